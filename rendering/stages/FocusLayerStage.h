#pragma once
// Stage 5: what rays see from their start on, of focus and context.

#include "rendering/passes/FocusLayerPass.h"
#include "rendering/stages/OcclusionStage.h"
#include "rendering/stages/PictureStarts.h"

namespace fenestra {

struct FocusLayerKey {
  Version starts;     ///< none without a cutaway; the hits, where an exploded view has a focus
  Version occlusion;  ///< none without ambient occlusion and shadows
  std::uint64_t volume, focus, transfer, gradient, palette;  ///< versions of the scene on the GPU
  double focusExtinction;
  std::optional<MethodStages::Fading> fading;
  std::optional<MethodStages::Explosion> explosion;
  bool focusAlone;  ///< the context shows by its greatest value, in MaximumStage
  Shading shading;
  Camera camera;
  glm::ivec2 size;
  FocusLayerPass::Sampling sampling;
  Clip clip;
  bool operator==(const FocusLayerKey&) const = default;
};

/// Every picture has this layer; where nothing is laid over it, it is the picture.
class FocusLayerStage : public KeyedStage<FocusLayerKey> {
 public:
  FocusLayerStage(StageList& list, const StartStages& own, const PictureStarts& starts,
                  const OcclusionStage& occlusion);
  bool isUsed(const Frame&) const override { return true; }
  void begin(const Frame& frame, Steps& steps) override;

  /// Premultiplied RGBA32F.
  Output layer() const { return {layer_, version()}; }

 private:
  FocusLayerKey keyOf(const Frame& frame) const;
  void addLayer(const Frame& frame, Steps& steps, Regions regions);

  const StartStages& own_;
  const PictureStarts& starts_;
  const OcclusionStage& occlusion_;
  FocusLayerPass pass_{gpu().programs()};
  gl::Texture layer_;
};

}  // namespace fenestra
