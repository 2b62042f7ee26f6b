#include "rendering/EdgeSamples.h"

#include <algorithm>

#include "rendering/PassChain.h"
#include "rendering/scene/EdgeRays.h"

namespace fenestra {
namespace {

/// So many pixels more on each side, within a picture.
gl::Region grown(const gl::Region& region, int margin, glm::ivec2 size) {
  const glm::ivec2 first = glm::max(region.origin - margin, 0),
                   end = glm::min(region.origin + region.size + margin, size);
  return {first, glm::max(end - first, 0)};
}

}  // namespace

std::size_t EdgeSamples::bytes() const {
  std::size_t sum = edgePass_.bytes() + focusLayerPass_.bytes();
  if (smoothed_) sum += smoothed_.bytes();
  return sum;
}

void EdgeSamples::find(PassChain& chain, Regions regions) {
  const gl::Texture& picture = chain.unsmoothed();
  std::optional<EdgePass::Opening> opening;
  if (chain.frame->hasCutaway) opening.emplace(EdgePass::Opening{chain.hitPoints, chain.distances, chain.widths});
  edgePass_.find(chain.steps, chain.gpu->schedule(), picture, opening, regions,
                 sized(smoothed_, gl::Format::RGBA32F, glm::ivec2(picture.size()), gl::Filter::Linear));
}

void EdgeSamples::draw(PassChain& chain) {
  rays_.clear();
  stretches_.clear();
  // At least one, which may have no weight: that compiles the programs ahead of the first edge.
  const int count = std::max(edgePass_.count(), 1);
  const glm::ivec2 size = 2 * Scatter{&edgePass_.list(), 0, std::min(count, mostPixels)}.blocks();
  for (int first = 0; first < count; first += mostPixels)
    addBatch(chain, {&edgePass_.list(), first, std::min(count - first, mostPixels)}, size);
  chain.steps.then([this] { batch_ = {}; });
}

void EdgeSamples::addBatch(PassChain& chain, const Scatter& batch, glm::ivec2 size) {
  const RayFrame& rays = rays_.emplace_back(chain.rays->scattered(batch));
  const gl::Region region{glm::ivec2(0), 2 * batch.blocks()};
  if (chain.frame->hasCutaway) {
    chain.hitPointPass.run(chain.steps, *chain.gpu, rays, region, sized(batch_.hitPoints, gl::Format::RG32F, size));
    if (chain.opening)
      addStartsApart(chain, rays, region, size);
    else
      addStarts(chain, rays, region, size);
  }
  if (chain.explodesAroundFocus())
    chain.hitPointPass.run(chain.steps, *chain.gpu, rays, region, sized(batch_.hitPoints, gl::Format::RG32F, size));
  const gl::Texture& drawn =
      chain.exploded ? addExploded(chain, batch, region, size) : addLayers(chain, rays, region, size);
  edgePass_.blend(chain.steps, chain.gpu->schedule(), batch, chain.unsmoothed(), drawn, smoothed_);
}

void EdgeSamples::addStarts(PassChain& chain, const RayFrame& rays, const gl::Region& region, glm::ivec2 size) {
  const glm::dvec2 widths = chain.widths;
  const RayStartPass::Inputs inputs{batch_.hitPoints, chain.focusFilled, chain.distances, widths.x,
                                    widths.x + widths.y + edges::distanceBeyond};
  const Regions regions(&region, 1);
  const Schedule schedule = chain.gpu->schedule();
  const bool edited = !chain.frame->strokes.empty();
  if (edited)
    chain.editMapPass.run(chain.steps, schedule, rays, inputs, chain.frame->strokes, regions,
                          sized(batch_.editMap, gl::Format::RG32F, size));
  chain.rayStartPass.run(chain.steps, schedule, rays, inputs, edited ? &batch_.editMap : nullptr, regions,
                         sized(batch_.rayStart, gl::Format::R32F, size),
                         &sized(batch_.distances, gl::Format::R32F, size));
}

void EdgeSamples::addStartsApart(PassChain& chain, const RayFrame& rays, const gl::Region& region, glm::ivec2 size) {
  const RemovedPass::Opening cut = chain.cutOpening();
  const RemovedPass::Outputs outputs{sized(batch_.rayStart, gl::Format::R32F, size),
                                     sized(batch_.hole, gl::Format::RG32F, size),
                                     sized(batch_.distances, gl::Format::R32F, size),
                                     cut.editMap ? &sized(batch_.editMap, gl::Format::RG32F, size) : nullptr};
  chain.removedPass.runParts(chain.steps, chain.gpu->schedule(), rays, batch_.hitPoints, cut, chain.hasHoles(),
                             chain.shortestVoxelSide(), chain.faces, region, outputs);
}

const gl::Texture& EdgeSamples::addLayers(PassChain& chain, const RayFrame& rays, const gl::Region& region,
                                          glm::ivec2 size) {
  const PassChain::Frame& frame = *chain.frame;
  const Look& look = frame.scene.look;
  const GpuScene& gpu = *chain.gpu;
  const Regions regions(&region, 1);
  const gl::Texture* occlusion = chain.occlusionOfFrame();
  const FocusLayerPass::Sampling sampling = FocusLayerPass::followingEveryRay(frame.sampling);
  std::optional<FocusLayerPass::Opening> cut;
  if (frame.hasCutaway)
    cut.emplace(FocusLayerPass::Opening{batch_.hitPoints, batch_.rayStart, chain.opening ? &batch_.hole : nullptr,
                                        &chain.rayStart});
  focusLayerPass_.run(chain.steps, gpu, look, rays, cut, sampling, regions,
                      sized(batch_.focusLayer, gl::Format::RGBA32F, size), occlusion);
  const gl::Texture* picture = &batch_.focusLayer;
  if (frame.hasCutaway) {
    CompositePass::Inputs inputs{batch_.focusLayer, batch_.hitPoints, batch_.distances, chain.widths};
    inputs.scattered = true;
    if (batch_.editMap) inputs.editMap = &batch_.editMap;
    if (chain.opening) inputs.rayStart = &batch_.rayStart;
    if (chain.protectedLayer) {
      chain.protectedLayerPass.run(chain.steps, gpu, look, rays, {batch_.hitPoints, batch_.rayStart}, sampling, regions,
                                   sized(batch_.protectedLayer, gl::Format::RGBA32F, size), occlusion);
      inputs.protectedLayer = &batch_.protectedLayer;
    }
    if (frame.hasContextLayer) {
      chain.contextLayerPass.run(chain.steps, gpu, look.shading, rays, batch_.hitPoints, regions,
                                 sized(batch_.contextLayer, gl::Format::RGBA32F, size),
                                 sized(batch_.silhouette, gl::Format::R32F, size));
      inputs.contextLayer = &batch_.contextLayer;
      inputs.silhouette = &batch_.silhouette;
    }
    chain.compositePass.run(chain.steps, gpu, inputs, look, regions, sized(batch_.composed, gl::Format::RGBA32F, size));
    picture = &batch_.composed;
  }
  if (!gpu.exemptLabels().any()) return *picture;
  chain.exemptPass.run(chain.steps, gpu, look, rays, *picture, sampling, regions,
                       sized(batch_.exempted, gl::Format::RGBA32F, size), occlusion);
  return batch_.exempted;
}

const gl::Texture& EdgeSamples::addExploded(PassChain& chain, const Scatter& batch, const gl::Region& region,
                                            glm::ivec2 size) {
  auto& stretches = stretches_.emplace_back();
  for (const FocusLayerPass::ExplodedStretch& stretch : chain.stretches)
    stretches.push_back({stretch.shown, stretch.rays.scattered(batch), stretch.fromPicture});
  const FocusLayerPass::Sampling sampling = FocusLayerPass::followingEveryRay(chain.frame->sampling);
  focusLayerPass_.runExploded(chain.steps, *chain.gpu, chain.frame->scene.look, stretches,
                              chain.explodesAroundFocus() ? &batch_.hitPoints : nullptr, sampling, Regions(&region, 1),
                              sized(batch_.focusLayer, gl::Format::RGBA32F, size));
  return batch_.focusLayer;
}

void PassChain::findEdges() {
  if (!hasSmoothEdges(frame->scene.look, frame->view)) {
    edgeSamples.reset();
    edgePixels.forget();
    edgeRays.forget();
    return;
  }
  if (!edgeSamples) edgeSamples = std::make_unique<EdgeSamples>(gpu->programs());
  // A pixel's contrast depends on those beside it, and its rays reach over its rim.
  std::vector<gl::Region> changed;
  for (const gl::Region& region : frame->changed) changed.push_back(grown(region, 2, frame->view.size));
  const EdgeKey key{focus.version(), composed ? std::optional(composite.version()) : std::nullopt,
                    exempted ? std::optional(exempt.version()) : std::nullopt};
  addIfStale(Pass::Edges, edgePixels, key, changed, [&](Regions regions) { edgeSamples->find(*this, regions); });
}

void PassChain::drawEdges() {
  if (!edgeSamples) return;
  addIfStale(Pass::EdgeRays, edgeRays, EdgeSampleKey{edgePixels.version()}, frame->changed,
             [&](Regions) { edgeSamples->draw(*this); });
}

}  // namespace fenestra
