#pragma once
// Which of the context's edges are drawn over the focus, where they may cover but a share of it.

#include "rendering/passes/ContextLinesPass.h"
#include "rendering/scene/ContextLines.h"
#include "rendering/stages/ContextLayerStage.h"

namespace fenestra {

struct ContextLinesKey {
  Version hits, layer;
  double curvatureWeight, silhouetteWeight, share;
  bool operator==(const ContextLinesKey&) const = default;
};

class ContextLinesStage : public KeyedStage<ContextLinesKey> {
 public:
  ContextLinesStage(StageList& list, const PictureStarts& starts, const ContextLayerStage& layer);
  bool isUsed(const Frame& frame) const override {
    return frame.hasContextLayer && frame.look().contextLayer.share < 1.0;
  }
  void begin(const Frame& frame, Steps& steps) override;

  /// lines::all in pictures that draw every edge.
  double leastStrength() const { return version() == Version{} ? lines::all : pass_.leastStrength(); }

 private:
  const PictureStarts& starts_;
  const ContextLayerStage& layer_;
  ContextLinesPass pass_{gpu().programs()};
};

}  // namespace fenestra
