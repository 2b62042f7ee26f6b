#pragma once
// Stage 1: where the rays of a camera first meet the context or the focus, and the focus.

#include "rendering/passes/HitPointPass.h"
#include "rendering/stages/KeyedStage.h"

namespace fenestra {

struct HitKey {
  std::uint64_t volume, focus, gaps, importance;  ///< versions of the scene on the GPU
  Camera camera;
  glm::ivec2 size;
  Clip clip;
  HitSurface surface;
  bool operator==(const HitKey&) const = default;
};

class HitStage : public KeyedStage<HitKey> {
 public:
  HitStage(StageList& list, Eye eye);
  /// A cutaway needs the hits, and an exploded view those of its focus.
  bool isUsed(const Frame& frame) const override;
  void begin(const Frame& frame, Steps& steps) override;

  /// RG32F, of HitPointPass.
  Output hits() const { return {hits_, version()}; }

 private:
  Eye eye_;
  HitPointPass pass_{gpu().programs()};
  gl::Texture hits_;
};

}  // namespace fenestra
