#include "rendering/stages/ContextLinesStage.h"

namespace fenestra {

ContextLinesStage::ContextLinesStage(StageList& list, const PictureStarts& starts, const ContextLayerStage& layer)
    : KeyedStage(list, Pass::ContextLines), starts_(starts), layer_(layer) {
  owns(pass_);
}

void ContextLinesStage::begin(const Frame& frame, Steps& steps) {
  const ContextLayer& look = frame.look().contextLayer;
  const Output hits = starts_.hits(), layer = layer_.layer();
  const ContextLinesKey key{.hits = hits.version,
                            .layer = layer.version,
                            .curvatureWeight = look.curvatureWeight,
                            .silhouetteWeight = look.silhouetteWeight,
                            .share = look.share};
  update(frame.own, steps, key, {.part = nearFocus(gpu(), frame.own, 1.0)}, [&](Regions regions) {
    pass_.run(steps, gpu(), look, hits.image, layer.image, layer_.silhouette().image, regions);
  });
}

}  // namespace fenestra
