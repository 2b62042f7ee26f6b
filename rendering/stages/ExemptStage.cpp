#include "rendering/stages/ExemptStage.h"

#include "rendering/stages/Images.h"

namespace fenestra {

ExemptStage::ExemptStage(StageList& list, const MaximumStage& seen, const CompositeStage& composite,
                         const OcclusionStage& occlusion)
    : KeyedStage(list, Pass::Exempt), seen_(seen), composite_(composite), occlusion_(occlusion) {
  owns(picture_);
}

void ExemptStage::begin(const Frame& frame, Steps& steps) {
  const GpuScene::Versions& scene = gpu().versions();
  const Output below = firstOf({composite_.picture(), seen_.layer()});
  const ExemptKey key{.below = below.version,
                      .occlusion = occlusion_.nodes().version,
                      .volume = scene.volume,
                      .exemptLabels = scene.exemptLabels,
                      .transfer = scene.transfer,
                      .gradient = scene.gradient,
                      .shading = frame.look().shading,
                      .camera = frame.view().camera,
                      .size = frame.view().size,
                      .sampling = frame.sampling,
                      .clip = frame.own.rays.clip()};
  update(frame.own, steps, key, {.changed = changedStrokes(frame.own)}, [&](Regions regions) {
    pass_.run(steps, gpu(), frame.look(), frame.own.rays, below.image, frame.sampling, regions,
              sized(picture_, gl::Format::RGBA32F, frame.view().size, presented), occlusion_.nodes().orNull());
  });
}

}  // namespace fenestra
