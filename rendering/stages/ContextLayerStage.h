#pragma once
// Stage 6: the context's first surface over the focus, whose edges are drawn there.

#include "rendering/passes/ContextLayerPass.h"
#include "rendering/stages/PictureStarts.h"

namespace fenestra {

struct ContextLayerKey {
  Version hits;
  std::uint64_t derivative;  ///< version of the scene's derivative volume on the GPU
  Shading shading;
  bool operator==(const ContextLayerKey&) const = default;
};

class ContextLayerStage : public KeyedStage<ContextLayerKey> {
 public:
  ContextLayerStage(StageList& list, const PictureStarts& starts);
  bool isUsed(const Frame& frame) const override { return frame.hasContextLayer; }
  void begin(const Frame& frame, Steps& steps) override;

  // ContextLayerPass has both; they hold something on the focus's projection alone.
  Output layer() const { return {layer_, version()}; }            ///< RGBA32F
  Output silhouette() const { return {silhouette_, version()}; }  ///< R32F

 private:
  const PictureStarts& starts_;
  ContextLayerPass pass_{gpu().programs()};
  gl::Texture layer_, silhouette_;
};

}  // namespace fenestra
