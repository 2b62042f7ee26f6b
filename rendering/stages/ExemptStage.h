#pragma once
// Labels that are never clipped, before and behind the picture.

#include "rendering/passes/ExemptPass.h"
#include "rendering/stages/CompositeStage.h"

namespace fenestra {

struct ExemptKey {
  Version below;
  Version occlusion;                                       ///< none without ambient occlusion and shadows
  std::uint64_t volume, exemptLabels, transfer, gradient;  ///< versions of the scene on the GPU
  Shading shading;
  Camera camera;
  glm::ivec2 size;
  FocusLayerPass::Sampling sampling;
  Clip clip;
  bool operator==(const ExemptKey&) const = default;
};

class ExemptStage : public KeyedStage<ExemptKey> {
 public:
  ExemptStage(StageList& list, const MaximumStage& seen, const CompositeStage& composite,
              const OcclusionStage& occlusion);
  bool isUsed(const Frame& frame) const override { return gpu().exemptLabels().any() && !frame.exploded; }
  void begin(const Frame& frame, Steps& steps) override;

  /// Premultiplied RGBA32F.
  Output picture() const { return {picture_, version()}; }

 private:
  const MaximumStage& seen_;
  const CompositeStage& composite_;
  const OcclusionStage& occlusion_;
  ExemptPass pass_{gpu().programs()};
  gl::Texture picture_;
};

}  // namespace fenestra
