#include "rendering/stages/EdgeRayStage.h"

#include <algorithm>

#include "rendering/scene/EdgeRays.h"
#include "rendering/stages/Images.h"

namespace fenestra {

EdgeRayStage::EdgeRayStage(StageList& list, const Inputs& inputs) : KeyedStage(list, Pass::EdgeRays), inputs_(inputs) {
  owns(hits_, edits_, starts_, distances_, hole_, focusLayer_, protectedLayer_, contextLayer_, silhouette_, composed_,
       exempted_, editMapPass_, focusLayerPass_);
}

void EdgeRayStage::begin(const Frame& frame, Steps& steps) {
  update(frame.own, steps, {.found = inputs_.edges.found()}, {}, [&](Regions) { draw(frame, steps); });
}

void EdgeRayStage::draw(const Frame& frame, Steps& steps) {
  dropHoldings();  // what a run that was dropped half way left
  rays_.clear();
  stretches_.clear();
  // At least one, which may have no weight: that compiles the programs ahead of the first edge.
  const int count = std::max(inputs_.edges.count(), 1);
  const gl::Buffer& list = inputs_.edges.list();
  const glm::ivec2 size = gl::withoutPowersOfTwo(2 * Scatter{&list, 0, std::min(count, mostPixels)}.blocks());
  for (int first = 0; first < count; first += mostPixels) {
    const Scatter pixels{&list, first, std::min(count - first, mostPixels)};
    const Batch batch{.pixels = pixels,
                      .region = {glm::ivec2(0), 2 * pixels.blocks()},
                      .size = size,
                      .rays = rays_.emplace_back(frame.own.rays.scattered(pixels))};
    if (frame.hasCutaway || frame.explodesAroundFocus())
      hitPointPass_.run(steps, gpu(), batch.rays, batch.region, sized(hits_, gl::Format::RG32F, size));
    if (frame.other)
      addStartsApart(frame, steps, batch);
    else if (frame.hasCutaway)
      addStarts(frame, steps, batch);
    inputs_.edges.blend(steps, pixels, addLayers(frame, steps, batch));
  }
  steps.then([this] {
    dropHoldings();
    inputs_.edges.setBlended();
  });
}

void EdgeRayStage::addStarts(const Frame& frame, Steps& steps, const Batch& batch) {
  const glm::dvec2 widths = frame.widths();
  const RayStartPass::Inputs inputs{.hitPoints = hits_,
                                    .focusFilled = inputs_.own.fill.filled().image,
                                    .distances = inputs_.own.distances.distances().image,
                                    .openWidth = widths.x,
                                    .reach = widths.x + widths.y + edges::distanceBeyond};
  const Regions regions(&batch.region, 1);
  const bool edited = !frame.own.strokes->empty();
  if (edited)
    editMapPass_.run(steps, gpu().schedule(), batch.rays, inputs, *frame.own.strokes, regions,
                     sized(edits_, gl::Format::RG32F, batch.size));
  rayStartPass_.run(steps, gpu().schedule(), batch.rays, inputs, edited ? &edits_ : nullptr, regions,
                    sized(starts_, gl::Format::R32F, batch.size), &sized(distances_, gl::Format::R32F, batch.size));
}

void EdgeRayStage::addStartsApart(const Frame& frame, Steps& steps, const Batch& batch) {
  const RemovedPass::Outputs outputs{
      .rayStart = sized(starts_, gl::Format::R32F, batch.size),
      .hole = sized(hole_, gl::Format::RG32F, batch.size),
      .distances = sized(distances_, gl::Format::R32F, batch.size),
      .editMap = inputs_.removed.isEdited() ? &sized(edits_, gl::Format::RG32F, batch.size) : nullptr};
  inputs_.removed.addAlong(batch.rays, hits_, batch.region, frame, steps, outputs);
}

const gl::Texture& EdgeRayStage::addLayers(const Frame& frame, Steps& steps, const Batch& batch) {
  if (frame.exploded) {
    addExploded(frame, steps, batch);
    return focusLayer_;
  }
  addFocusLayer(frame, steps, batch);
  if (frame.hasCutaway) addComposite(frame, steps, batch);
  const gl::Texture& picture = frame.hasCutaway ? composed_ : focusLayer_;
  if (!gpu().exemptLabels().any()) return picture;
  exemptPass_.run(steps, gpu(), frame.look(), batch.rays, picture, FocusLayerPass::followingEveryRay(frame.sampling),
                  Regions(&batch.region, 1), sized(exempted_, gl::Format::RGBA32F, batch.size),
                  inputs_.occlusion.nodes().orNull());
  return exempted_;
}

void EdgeRayStage::addFocusLayer(const Frame& frame, Steps& steps, const Batch& batch) {
  std::optional<FocusLayerPass::RayStarts> opening;
  if (frame.hasCutaway)
    opening.emplace(FocusLayerPass::RayStarts{.hitPoints = hits_,
                                              .rayStart = starts_,
                                              .hole = frame.other ? &hole_ : nullptr,
                                              .pixelStarts = inputs_.starts.starts().orNull()});
  focusLayerPass_.run(steps, gpu(), frame.look(), batch.rays, opening,
                      FocusLayerPass::followingEveryRay(frame.sampling), Regions(&batch.region, 1),
                      sized(focusLayer_, gl::Format::RGBA32F, batch.size), inputs_.occlusion.nodes().orNull());
}

void EdgeRayStage::addExploded(const Frame& frame, Steps& steps, const Batch& batch) {
  auto& stretches = stretches_.emplace_back();
  for (const FocusLayerPass::ExplodedStretch& stretch : frame.exploded->stretches)
    stretches.push_back({stretch.shown, stretch.rays.scattered(batch.pixels), stretch.fromPicture});
  focusLayerPass_.runExploded(steps, gpu(), frame.look(), stretches, frame.explodesAroundFocus() ? &hits_ : nullptr,
                              FocusLayerPass::followingEveryRay(frame.sampling), Regions(&batch.region, 1),
                              sized(focusLayer_, gl::Format::RGBA32F, batch.size));
}

void EdgeRayStage::addComposite(const Frame& frame, Steps& steps, const Batch& batch) {
  const Regions regions(&batch.region, 1);
  CompositePass::Inputs inputs{.focusLayer = focusLayer_,
                               .hitPoints = hits_,
                               .distances = distances_,
                               .widths = frame.widths(),
                               .editMap = edits_ ? &edits_ : nullptr,
                               .rayStart = frame.other ? &starts_ : nullptr,
                               .scattered = true};
  if (inputs_.protectedLabels.layer()) {
    protectedLayerPass_.run(steps, gpu(), frame.look(), batch.rays, {.hitPoints = hits_, .rayStart = starts_},
                            FocusLayerPass::followingEveryRay(frame.sampling), regions,
                            sized(protectedLayer_, gl::Format::RGBA32F, batch.size),
                            inputs_.occlusion.nodes().orNull());
    inputs.protectedLayer = &protectedLayer_;
  }
  if (frame.hasContextLayer) {
    contextLayerPass_.run(steps, gpu(), frame.look().shading, batch.rays, hits_, regions,
                          sized(contextLayer_, gl::Format::RGBA32F, batch.size),
                          sized(silhouette_, gl::Format::R32F, batch.size));
    inputs.contextLayer = &contextLayer_;
    inputs.silhouette = &silhouette_;
    inputs.leastLine = inputs_.lines.leastStrength();
  }
  compositePass_.run(steps, gpu(), inputs, frame.look(), regions, sized(composed_, gl::Format::RGBA32F, batch.size));
}

}  // namespace fenestra
