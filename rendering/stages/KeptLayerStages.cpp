#include "rendering/stages/KeptLayerStages.h"

#include "rendering/stages/Images.h"

namespace fenestra {

KeptLayerStage::KeptLayerStage(StageList& list, Pass pass, const PictureStarts& starts, const OcclusionStage& occlusion)
    : KeyedStage(list, pass), starts_(starts), occlusion_(occlusion) {
  owns(layer_);
}

KeptLayerKey KeptLayerStage::keyOf(const Frame& frame) const {
  const GpuScene::Versions& scene = gpu().versions();
  return {.starts = starts_.starts().version,
          .occlusion = occlusion_.nodes().version,
          .volume = scene.volume,
          .protectedLabels = 0,
          .transfer = scene.transfer,
          .gradient = scene.gradient,
          .shading = frame.look().shading,
          .sampling = frame.sampling,
          .removedFocus = std::nullopt};
}

void KeptLayerStage::draw(const Frame& frame, Steps& steps, const KeptLayerKey& key, ProtectedLayerPass::Shown shown) {
  // Rays farther from the focus start where they did, unless a stroke opened them.
  const auto part = frame.own.strokes->empty() && frame.opensNearFocus()
                        ? nearFocus(gpu(), frame.own, frame.widths().x + 1.0)
                        : std::nullopt;
  const bool anew = part && isStale(key);
  update(frame.own, steps, key, {.part = part, .changed = changedStrokes(frame.own)}, [&](Regions regions) {
    gl::Texture& layer = sized(layer_, gl::Format::RGBA32F, frame.view().size);
    if (anew) clearAround(*part, layer);
    pass_.run(steps, gpu(), frame.look(), frame.own.rays,
              {.hitPoints = starts_.hits().image, .rayStart = starts_.starts().image}, frame.sampling, regions, layer,
              occlusion_.nodes().orNull(), shown);
  });
}

void FaintLayerStage::begin(const Frame& frame, Steps& steps) {
  using Shown = ProtectedLayerPass::Shown;
  const bool levels = !gpu().importance().empty();
  const GpuScene::Versions& scene = gpu().versions();
  KeptLayerKey key = keyOf(frame);
  if (levels)
    key.removedFocus = {
        .focus = scene.focus, .palette = scene.palette, .extinction = frame.look().focusAppearance.extinction};
  draw(frame, steps, key, levels ? Shown::AllWithFocus : Shown::All);
}

void ProtectedLayerStage::begin(const Frame& frame, Steps& steps) {
  KeptLayerKey key = keyOf(frame);
  key.protectedLabels = gpu().versions().protectedLabels;
  draw(frame, steps, key, ProtectedLayerPass::Shown::ProtectedLabels);
}

}  // namespace fenestra
