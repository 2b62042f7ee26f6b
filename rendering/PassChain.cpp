#include "rendering/PassChain.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "rendering/ViewSampling.h"
#include "rendering/scene/EdgeRays.h"
#include "rendering/scene/Fading.h"
#include "rendering/scene/Lighting.h"

namespace fenestra {
namespace {

/// Where another camera cuts the opening, rays may see nothing on a part of their way: only the integral that keeps a
/// bound knows where a ray ends. Each of the two parts gets half of it.
FocusLayerPass::Sampling inParts(FocusLayerPass::Sampling sampling) {
  sampling.maxError = 0.5 * sampling.maxError.value_or(FocusLayerPass::usualBound);
  return sampling;
}

/// Fills with zeros all of a picture but one region.
void clearAround(const gl::Region& region, gl::Texture& picture) {
  const glm::ivec2 size(picture.size()), first = region.origin, end = first + region.size;
  picture.clear({0, 0}, {size.x, first.y});
  picture.clear({0, end.y}, {size.x, size.y - end.y});
  picture.clear({0, first.y}, {first.x, region.size.y});
  picture.clear({end.x, first.y}, {size.x - end.x, region.size.y});
}

Clip clipOf(const Look& look, const GpuScene& gpu) {
  const Clipping& clipping = look.clipping;
  Clip clip{halfSpaces(clipping, gpu.grid())};
  if (!clipping.grey || (clip.kept.empty() && !explosionOf(look))) return clip;
  // 0 to 1 over the window of real values, as windowed() has it.
  const double perReal = 1.0 / clipping.grey->width, low = clipping.grey->level - 0.5 * clipping.grey->width;
  const VolumeTexture& volume = gpu.volume();
  const glm::dvec2 grey(volume.slope * perReal, (volume.offset - low) * perReal);
  clip.grey = gpu.lowIsWhite() ? glm::dvec2(-grey.x, 1.0 - grey.y) : grey;
  return clip;
}

}  // namespace

bool PassChain::shows(glm::ivec2 pixel) const {
  return picture() && glm::all(glm::greaterThanEqual(pixel, glm::ivec2(0))) &&
         glm::all(glm::lessThan(pixel, glm::ivec2(picture().size())));
}

glm::vec2 PassChain::hitAt(glm::ivec2 pixel) {
  if (hitPoints) return hitsToOpen().readTexel(pixel);
  // A plain volume rendering has no hit points: find this pixel's alone.
  Steps single;
  hitPointPass.run(single, *gpu, *rays, sized(pickedHit, gl::Format::RG32F, glm::ivec2(1)), pixel);
  single.advance();
  return pickedHit.readTexel(glm::ivec2(0));
}

glm::dvec2 PassChain::widthsInPixels(const Scene& scene) const {
  const Cutaway& cutaway = scene.look.cutaway;
  const MethodStages method = stagesOf(scene.look.method);
  const glm::dvec2 wanted =
      glm::max(glm::dvec2(method.hasWidth ? cutaway.openWidth : 0.0, method.hasBorder ? cutaway.borderWidth : 0.0),
               glm::dvec2(0.0));
  if (cutaway.unit == WidthUnit::Pixel) return wanted * pixelScale;
  const Grid& grid = gpu->grid();
  double depth = rays->depthOf(gpu->focus().centre(grid).value_or(grid.centre()));
  if (!(depth > 0.0)) depth = rays->depthOf(grid.centre());
  return wanted / rays->pixelSize(std::max(depth, 1e-3 * grid.boundingRadius()));
}

std::optional<gl::Region> PassChain::nearFocus(double reach) const {
  const std::optional<IndexBox>& box = gpu->openedBox();
  return box ? std::optional(rays->around(*box, reach)) : std::nullopt;
}

void PassChain::begin(const Scene& scene, const View& view) {
  peeled = gpu->peeled(scene);
  beginAsDrawn(peeled ? peeled->scene : scene, view);
}

void PassChain::beginAsDrawn(const Scene& scene, const View& view) {
  drop();
  gpu->update(scene);
  rays.emplace(view.camera, view.size, gpu->grid(), clipOf(scene.look, *gpu), gpu->refinement());
  pixelScale = view.pixelScale;
  background = glm::vec3(scene.look.background);
  backgroundRise = glm::vec3(fenestra::backgroundRise(scene.look));

  const Grid& grid = gpu->grid();
  std::optional<OpeningView> cutFor;
  if (hasCutaway(scene) && !onlyStarts)
    cutFor = openingOf(view, scene.look.cutaway, gpu->focus().centre(grid).value_or(grid.centre()));
  const FocusLayerPass::Sampling usual = samplingOf(view, grid, scene.look.shading.enabled);
  Frame& made = frame.emplace(Frame{.scene = scene, .view = view, .sampling = usual});
  // Only the integral within a bound knows what of a ray's opacity lies before a point. Its rays end at a quarter of
  // the bound, and so at the tolerance, as others do.
  if (fadingOf(scene.look) && !usual.maxError) {
    made.sampling.maxError = 4.0 * usual.tolerance;
    made.sampling.roughSteps = true;
  }
  if (cutFor || gpu->exemptLabels().any()) made.sampling = inParts(made.sampling);
  explode();
  made.hasCutaway = hasCutaway(scene);
  if (made.hasCutaway) made.method = stagesOf(scene.look.method);
  made.opening = cutFor;
  made.hasContextLayer = made.hasCutaway && scene.look.contextLayer.strength > 0.0;
  made.startBefore = start.version();
  made.drawn = gpu->versions();
  widths = made.hasCutaway ? widthsInPixels(scene) : glm::dvec2(0.0);
  if (cutFor)
    beginOpening(*cutFor);
  else
    dropOpening();

  // Strokes are in no pass's key: all that depends on them is patched together, or not at all.
  std::optional<ProjectedStrokes> before = std::exchange(strokes, std::nullopt);
  if (!before) forgetEdited();
  if (made.hasCutaway && !cutFor) made.strokes = project(scene.look.strokes, *rays);
  if (before) made.changed = changedRegions(*before, made.strokes, view.size, FocusLayerPass::reach(made.sampling));
  // Without any, a picture that is dropped half way has patched nothing.
  if (before && before->empty() && made.strokes.empty()) strokes = std::move(before);
}

void PassChain::drop() {
  steps.drop();
  frame.reset();
  if (opening) opening->drop();
}

void PassChain::beginOpening(const OpeningView& view) {
  if (!opening) {
    opening = std::make_unique<PassChain>(gpu);
    opening->onlyStarts = true;
    opening->stats = stats;
    // What the stages made for the picture's own camera.
    dropFill();
    dropCones();
    distanceMapPass.release();
    releaseEdits();
    distance.forget();
    forgetEdited();
  }
  opening->timing = timing;
  opening->beginAsDrawn(frame->scene, {.camera = view.camera, .size = view.size, .pixelScale = view.pixelScale});
  widths = opening->widths;
}

void PassChain::dropOpening() {
  if (!opening) return;
  opening.reset();
  faces = {};
  hole = {};
  editMap = {};
  removed.forget();
  distance.forget();
  forgetEdited();
}

void PassChain::beginStage() {
  constexpr std::array stages{
      &PassChain::findHitPoints,    &PassChain::findImportantHits, &PassChain::shapeOpening,
      &PassChain::mapDistances,     &PassChain::startRays,         &PassChain::occlude,
      &PassChain::drawFocusLayer,   &PassChain::drawFaintLayer,    &PassChain::drawProtectedLayer,
      &PassChain::drawContextLayer, &PassChain::findLens,          &PassChain::standWallsInside,
      &PassChain::compose,          &PassChain::addExempt,         &PassChain::standWallsAround,
      &PassChain::findEdges,        &PassChain::drawEdges};
  if (frame->stagesBegun == 0 && !frame->hasCutaway) dropCutaway();
  // The first stages, which only a cutaway has; but an exploded view needs the hits of its focus.
  constexpr std::size_t ofCutaway = 5;
  const bool findsHits = frame->hasCutaway || (frame->stagesBegun == 0 && explodesAroundFocus());
  if (!frame->hasCutaway && !findsHits) frame->stagesBegun = std::max(frame->stagesBegun, ofCutaway);
  if (frame->stagesBegun < (onlyStarts ? ofCutaway : stages.size())) {
    (this->*stages[frame->stagesBegun++])();
    return;
  }
  strokes = std::move(frame->strokes);
  frame.reset();
}

bool PassChain::advance(std::optional<double> milliseconds) try {
  // Another renderer may have brought the shared scene to another state.
  if (frame && gpu->versions() != frame->drawn) {
    const Frame again = std::move(*frame);
    beginAsDrawn(again.scene, again.view);
  }
  const auto begun = std::chrono::steady_clock::now();
  bool advanced = false;
  while (frame) {
    std::optional<double> left = milliseconds;
    if (left) *left -= std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
    if (left && *left <= 0.0 && advanced) return false;
    if (opening && opening->frame) {
      advanced = true;
      if (!opening->advance(left)) return false;
      continue;
    }
    advanced = !steps.isDone();
    if (!steps.advance(left)) return false;
    beginStage();
  }
  return true;
} catch (...) {
  drop();
  throw;
}

void PassChain::occlude() {
  const Shading& shading = frame->scene.look.shading;
  if (!hasOcclusion(frame->scene.look)) {
    occlusionNodes = {};
    occlusionPass.release();
    occlusion.forget();
    return;
  }
  // A stroke changes what casts shadows all around it.
  if (!frame->changed.empty()) occlusion.forget();
  const PassChain& cuts = opening ? *opening : *this;
  const bool open = frame->hasCutaway;
  const glm::dvec3 light = shading.shadow > 0.0 ? lightDirection(rays->axes(), shading) : glm::dvec3(0.0);
  OcclusionKey key{open ? cuts.start.version() : 0,
                   open ? cuts.hits.version() : 0,
                   open ? std::optional(cuts.rays->camera()) : std::nullopt,
                   gpu->versions().occluders,
                   light,
                   {shading.occlusion, shading.shadow},
                   rays->clip(),
                   {}};
  // A picture that is soon replaced is content with less, but takes what is there.
  if (frame->view.quality == Quality::Draft && !frame->view.maxError && occlusion.isStale(key))
    key.directions = occlusion::draftDirections;
  addIfStale(Pass::Occlusion, occlusion, key, {}, [&](Regions) {
    std::optional<OcclusionPass::Opening> cut;
    if (open) cut.emplace(OcclusionPass::Opening{*cuts.rays, cuts.hitsToOpen(), cuts.rayStart});
    occlusionPass.run(steps, *gpu, shading, light, rays->clip(), cut, key.directions, occlusionNodes);
  });
}

void PassChain::drawFocusLayer() {
  const GpuScene::Versions& version = gpu->versions();
  const Look& look = frame->scene.look;
  const View& view = frame->view;
  const int reach = FocusLayerPass::reach(frame->sampling);
  const FocusLayerKey key{frame->hasCutaway       ? start.version()
                          : explodesAroundFocus() ? hits.version()
                                                  : 0,
                          opening ? removed.version() : 0,
                          occlusionVersion(),
                          version.volume,
                          version.focus,
                          version.transfer,
                          version.gradient,
                          version.palette,
                          look.focusAppearance.extinction,
                          fadingOf(look),
                          explosionOf(look),
                          look.shading,
                          view.camera,
                          view.size,
                          frame->sampling,
                          rays->clip()};
  FocusLayerKey keyBefore = key;
  keyBefore.rayStart = frame->startBefore;
  const bool onlyMoved = frame->moved && !focus.isStale(keyBefore), anew = !onlyMoved && focus.isStale(key);
  const gl::Region seen = nearVolume(reach);
  addIfStale(
      Pass::FocusLayer, focus, key, anew ? Regions() : Regions(frame->changed),
      [&](Regions regions) {
        std::optional<FocusLayerPass::Opening> cut;
        if (frame->hasCutaway) cut.emplace(FocusLayerPass::Opening{hitsToOpen(), rayStart, opening ? &hole : nullptr});
        gl::Texture& layer = sized(focusLayer, gl::Format::RGBA32F, view.size, presented);
        if (anew) clearAround(seen, layer);
        if (exploded)
          focusLayerPass.runExploded(steps, *gpu, look, stretches, explodesAroundFocus() ? &hitPoints : nullptr,
                                     frame->sampling, regions, layer);
        else
          focusLayerPass.run(steps, *gpu, look, *rays, cut, frame->sampling, regions, layer, occlusionOfFrame());
      },
      onlyMoved ? nearFocus(*frame->moved + reach) : seen);
}

void PassChain::drawFaintLayer() {
  if (!frame->method.keepsRemoved()) {
    faintLayer = {};
    faint.forget();
    return;
  }
  const GpuScene::Versions& version = gpu->versions();
  const Look& look = frame->scene.look;
  const bool levels = !gpu->importance().empty();
  const ProtectedLayerKey key{
      start.version(),
      opening ? removed.version() : 0,
      occlusionVersion(),
      version.volume,
      0,
      version.transfer,
      version.gradient,
      look.shading,
      frame->sampling,
      levels ? std::optional(FocusLookKey{version.focus, version.palette, look.focusAppearance.extinction})
             : std::nullopt};
  drawRemoved(Pass::FaintLayer, faint, key, faintLayer,
              levels ? ProtectedLayerPass::Shown::AllWithFocus : ProtectedLayerPass::Shown::All);
}

void PassChain::drawProtectedLayer() {
  if (!frame->hasCutaway || !gpu->protectedLabels().any()) {
    protectedLayer = {};
    guard.forget();
    return;
  }
  const GpuScene::Versions& version = gpu->versions();
  const Look& look = frame->scene.look;
  const ProtectedLayerKey key{start.version(),         opening ? removed.version() : 0,
                              occlusionVersion(),      version.volume,
                              version.protectedLabels, version.transfer,
                              version.gradient,        look.shading,
                              frame->sampling,         std::nullopt};
  drawRemoved(Pass::ProtectedLayer, guard, key, protectedLayer, ProtectedLayerPass::Shown::ProtectedLabels);
}

void PassChain::drawRemoved(Pass pass, Memo<ProtectedLayerKey>& memo, const ProtectedLayerKey& key,
                            gl::Texture& texture, ProtectedLayerPass::Shown shown) {
  // Rays farther from the focus start where they did, unless a stroke opened them.
  const auto part = frame->strokes.empty() && opensNearFocus() ? nearFocus(widths.x + 1.0) : std::nullopt;
  const bool anew = part && memo.isStale(key);
  addIfStale(
      pass, memo, key, frame->changed,
      [&](Regions regions) {
        gl::Texture& layer = sized(texture, gl::Format::RGBA32F, frame->view.size);
        if (anew) clearAround(*part, layer);
        protectedLayerPass.run(steps, *gpu, frame->scene.look, *rays, {hitsToOpen(), rayStart}, frame->sampling,
                               regions, layer, occlusionOfFrame(), shown);
      },
      part);
}

void PassChain::drawContextLayer() {
  if (!frame->hasContextLayer) {
    contextLayer = {};
    silhouette = {};
    context.forget();
    return;
  }
  const Shading& shading = frame->scene.look.shading;
  addIfStale(
      Pass::ContextLayer, context,
      ContextLayerKey{hits.version(), openedHits ? cones.version() : 0, gpu->versions().derivative, shading}, {},
      [&](Regions regions) {
        contextLayerPass.run(steps, *gpu, shading, *rays, hitsToOpen(), regions,
                             sized(contextLayer, gl::Format::RGBA32F, frame->view.size),
                             sized(silhouette, gl::Format::R32F, frame->view.size));
      },
      nearFocus(1.0));
}

void PassChain::findLens() {
  if (!frame->method.lens) {
    lensSurface = {};
    lensPass.release();
    lens.forget();
    return;
  }
  const Grid& grid = gpu->grid();
  const glm::dvec3 middle =
      placeOf(*frame->method.lens, frame->view.slices, gpu->focus().centre(grid).value_or(grid.centre()));
  addIfStale(Pass::Lens, lens, LensKey{hits.version(), gpu->versions().derivative, middle}, {}, [&](Regions regions) {
    lensPass.run(steps, *gpu, *rays, hitsToOpen(), middle, regions,
                 sized(lensSurface, gl::Format::RGBA32F, frame->view.size));
  });
}

void PassChain::compose() {
  if (!frame->hasCutaway) {
    composed = {};
    composite.forget();
    return;
  }
  const Look& look = frame->scene.look;
  const bool hasLayer = frame->hasContextLayer;
  const CompositeKey key{focus.version(),
                         distance.version(),
                         hasLayer ? std::optional(context.version()) : std::nullopt,
                         hasLayer ? std::optional(gpu->versions().transfer) : std::nullopt,
                         protectedLayer ? std::optional(guard.version()) : std::nullopt,
                         faintLayer ? std::optional(faint.version()) : std::nullopt,
                         lensSurface ? std::optional(lens.version()) : std::nullopt,
                         walledLayer ? std::optional(walls.version()) : std::nullopt,
                         frame->method,
                         widths,
                         look.cutaway.borderColour,
                         look.contextLayer};
  // What lies over the focus layer lies near the focus; elsewhere the picture is the focus layer.
  const auto& last = composite.key();
  const bool sameBelow = last && last->sameBelow(key), stale = composite.isStale(key);
  // Strokes may open anywhere, and so bring protected labels anywhere; the line around a lens lies anywhere.
  const auto part = !opensNearFocus() || lensSurface || ((protectedLayer || faintLayer) && !frame->strokes.empty())
                        ? std::nullopt
                        : nearFocus(std::max(sameBelow ? last->reach() : 0.0, key.reach()));
  addIfStale(
      Pass::Composite, composite, key, frame->changed,
      [&](Regions regions) {
        gl::Texture& picture = sized(composed, gl::Format::RGBA32F, frame->view.size, presented);
        if (stale && !sameBelow && part) picture.copy(composedOver());
        CompositePass::Inputs inputs{composedOver(), hitsToOpen(), distances, widths};
        if (editMap) inputs.editMap = &editMap;
        if (opening) inputs.rayStart = &rayStart;
        if (faintLayer) inputs.faintLayer = &faintLayer;
        if (lensSurface) inputs.lensSurface = &lensSurface;
        if (protectedLayer) inputs.protectedLayer = &protectedLayer;
        if (hasLayer) {
          inputs.contextLayer = &contextLayer;
          inputs.silhouette = &silhouette;
        }
        compositePass.run(steps, *gpu, inputs, look, regions, picture);
      },
      part);
}

void PassChain::addExempt() {
  if (!gpu->exemptLabels().any() || exploded) {
    exempted = {};
    exempt.forget();
    return;
  }
  const GpuScene::Versions& version = gpu->versions();
  const Look& look = frame->scene.look;
  const View& view = frame->view;
  const gl::Texture& below = composed ? composed : focusLayer;
  const ExemptKey key{focus.version(),      composed ? std::optional(composite.version()) : std::nullopt,
                      occlusionVersion(),   version.volume,
                      version.exemptLabels, version.transfer,
                      version.gradient,     look.shading,
                      view.camera,          view.size,
                      frame->sampling,      rays->clip()};
  addIfStale(Pass::Exempt, exempt, key, frame->changed, [&](Regions regions) {
    exemptPass.run(steps, *gpu, look, *rays, below, frame->sampling, regions,
                   sized(exempted, gl::Format::RGBA32F, view.size, presented), occlusionOfFrame());
  });
}

}  // namespace fenestra
