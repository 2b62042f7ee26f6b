#pragma once
// What a lens reads of the context's first surface.

#include "rendering/passes/LensPass.h"
#include "rendering/stages/PictureStarts.h"

namespace fenestra {

struct LensKey {
  Version hits;
  std::uint64_t derivative;  ///< version of the scene's derivative volume on the GPU
  glm::dvec3 middle;         ///< what the lens lies over, world
  bool operator==(const LensKey&) const = default;
};

class LensStage : public KeyedStage<LensKey> {
 public:
  LensStage(StageList& list, const PictureStarts& starts);
  bool isUsed(const Frame& frame) const override { return frame.method.lens.has_value(); }
  void begin(const Frame& frame, Steps& steps) override;

  /// RGBA32F, of LensPass.
  Output surface() const { return {surface_, version()}; }

 private:
  const PictureStarts& starts_;
  LensPass pass_{gpu().programs()};
  gl::Texture surface_;
};

}  // namespace fenestra
