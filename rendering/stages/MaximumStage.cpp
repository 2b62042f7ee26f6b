#include "rendering/stages/MaximumStage.h"

#include "rendering/scene/Maximum.h"
#include "rendering/stages/Images.h"

namespace fenestra {

MaximumStage::MaximumStage(StageList& list, const FocusLayerStage& focusLayer, const PictureStarts& starts)
    : KeyedStage(list, Pass::Maximum), focusLayer_(focusLayer), starts_(starts) {
  owns(picture_);
}

bool MaximumStage::isUsed(const Frame& frame) const { return maximumOf(frame.look()).has_value(); }

void MaximumStage::begin(const Frame& frame, Steps& steps) {
  const GpuScene::Versions& scene = gpu().versions();
  const MaximumKey key{.focusLayer = focusLayer_.layer().version,
                       .starts = frame.hasCutaway ? starts_.starts().version : Version{},
                       .volume = scene.volume,
                       .focus = scene.focus,
                       .transfer = scene.transfer,
                       .maximum = *maximumOf(frame.look()),
                       .camera = frame.view().camera,
                       .size = frame.view().size,
                       .clip = frame.own.rays.clip()};
  update(frame.own, steps, key, {.changed = changedStrokes(frame.own)}, [&](Regions regions) {
    std::optional<FocusLayerPass::RayStarts> opening;
    if (frame.hasCutaway)
      opening.emplace(FocusLayerPass::RayStarts{
          .hitPoints = starts_.hits().image, .rayStart = starts_.starts().image, .hole = starts_.hole()});
    // Half of the bound is the focus layer's.
    const double least = 0.25 * frame.sampling.maxError.value_or(FocusLayerPass::usualBound);
    pass_.run(steps, gpu(), key.maximum, frame.own.rays, opening, focusLayer_.layer().image, least, regions,
              sized(picture_, gl::Format::RGBA32F, frame.view().size, presented));
  });
}

}  // namespace fenestra
