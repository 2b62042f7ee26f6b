#include "rendering/stages/ContextLayerStage.h"

#include "rendering/stages/Images.h"

namespace fenestra {

ContextLayerStage::ContextLayerStage(StageList& list, const PictureStarts& starts)
    : KeyedStage(list, Pass::ContextLayer), starts_(starts) {
  owns(layer_, silhouette_);
}

void ContextLayerStage::begin(const Frame& frame, Steps& steps) {
  const Shading& shading = frame.look().shading;
  const Output hits = starts_.hits();
  const ContextLayerKey key{.hits = hits.version, .derivative = gpu().versions().derivative, .shading = shading};
  update(frame.own, steps, key, {.part = nearFocus(gpu(), frame.own, 1.0)}, [&](Regions regions) {
    pass_.run(steps, gpu(), shading, frame.own.rays, hits.image, regions,
              sized(layer_, gl::Format::RGBA32F, frame.view().size),
              sized(silhouette_, gl::Format::R32F, frame.view().size));
  });
}

}  // namespace fenestra
