#include "rendering/stages/FocusLayerStage.h"

#include "rendering/scene/Fading.h"
#include "rendering/scene/Maximum.h"
#include "rendering/stages/Images.h"

namespace fenestra {

FocusLayerStage::FocusLayerStage(StageList& list, const StartStages& own, const PictureStarts& starts,
                                 const OcclusionStage& occlusion)
    : KeyedStage(list, Pass::FocusLayer), own_(own), starts_(starts), occlusion_(occlusion) {
  owns(layer_, pass_);
}

FocusLayerKey FocusLayerStage::keyOf(const Frame& frame) const {
  const GpuScene::Versions& scene = gpu().versions();
  const Look& look = frame.look();
  return {.starts = frame.hasCutaway              ? starts_.starts().version
                    : frame.explodesAroundFocus() ? own_.hits.hits().version
                                                  : Version{},
          .occlusion = occlusion_.nodes().version,
          .volume = scene.volume,
          .focus = scene.focus,
          .transfer = scene.transfer,
          .gradient = scene.gradient,
          .palette = scene.palette,
          .focusExtinction = look.focusAppearance.extinction,
          .fading = fadingOf(look),
          .explosion = explosionOf(look),
          .focusAlone = maximumOf(look).has_value(),
          .shading = look.shading,
          .camera = frame.view().camera,
          .size = frame.view().size,
          .sampling = frame.sampling,
          .clip = frame.own.rays.clip()};
}

void FocusLayerStage::begin(const Frame& frame, Steps& steps) {
  const FocusLayerKey key = keyOf(frame);
  const int reach = FocusLayerPass::reach(frame.sampling);
  const auto& moved = own_.starts.moved();
  FocusLayerKey keyBefore = key;
  if (moved) keyBefore.starts = moved->before;
  const bool onlyMoved = moved && !isStale(keyBefore), anew = !onlyMoved && isStale(key);
  const gl::Region seen = nearVolume(gpu(), frame, reach);
  Extent extent{.part = onlyMoved ? nearFocus(gpu(), frame.own, moved->reach + reach) : seen};
  if (!anew) extent.changed = changedStrokes(frame.own);
  update(frame.own, steps, key, extent, [&](Regions regions) {
    sized(layer_, gl::Format::RGBA32F, frame.view().size, presented);
    if (anew) clearAround(seen, layer_);
    addLayer(frame, steps, regions);
  });
}

void FocusLayerStage::addLayer(const Frame& frame, Steps& steps, Regions regions) {
  if (frame.exploded) {
    pass_.runExploded(steps, gpu(), frame.look(), frame.exploded->stretches,
                      frame.explodesAroundFocus() ? own_.hits.hits().orNull() : nullptr, frame.sampling, regions,
                      layer_);
    return;
  }
  std::optional<FocusLayerPass::RayStarts> opening;
  if (frame.hasCutaway)
    opening.emplace(FocusLayerPass::RayStarts{
        .hitPoints = starts_.hits().image, .rayStart = starts_.starts().image, .hole = starts_.hole()});
  pass_.run(steps, gpu(), frame.look(), frame.own.rays, opening, frame.sampling, regions, layer_,
            occlusion_.nodes().orNull());
}

}  // namespace fenestra
