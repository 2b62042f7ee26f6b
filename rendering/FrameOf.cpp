#include "rendering/FrameOf.h"

#include <algorithm>
#include <utility>

#include "rendering/ViewSampling.h"
#include "rendering/scene/Fading.h"
#include "rendering/scene/Maximum.h"

namespace fenestra {
namespace {

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

glm::dvec3 middleOf(const GpuScene& gpu) { return gpu.focus().centre(gpu.grid()).value_or(gpu.grid().centre()); }

/// w_open and w_border in rendered pixels.
glm::dvec2 widthsOf(const Look& look, const GpuScene& gpu, const View& view, const RayFrame& rays) {
  const Cutaway& cutaway = look.cutaway;
  const MethodStages method = stagesOf(look.method);
  const glm::dvec2 wanted =
      glm::max(glm::dvec2(method.hasWidth ? cutaway.openWidth : 0.0, method.hasBorder ? cutaway.borderWidth : 0.0),
               glm::dvec2(0.0));
  if (cutaway.unit == WidthUnit::Pixel) return wanted * view.pixelScale;
  const Grid& grid = gpu.grid();
  double depth = rays.depthOf(middleOf(gpu));
  if (!(depth > 0.0)) depth = rays.depthOf(grid.centre());
  return wanted / rays.pixelSize(std::max(depth, 1e-3 * grid.boundingRadius()));
}

Sight sightOf(const Look& look, const GpuScene& gpu, const View& view) {
  static const auto none = std::make_shared<const ProjectedStrokes>();
  return {.view = view,
          .rays = RayFrame(view.camera, view.size, gpu.grid(), clipOf(look, gpu), gpu.refinement()),
          .strokes = none,
          .strokesBefore = none};
}

/// The opening is cut for this sight.
void cutFor(Sight& sight, const Look& look, const GpuScene& gpu) {
  sight.widths = widthsOf(look, gpu, sight.view, sight.rays);
  ProjectedStrokes strokes = project(look.strokes, sight.rays);
  if (!strokes.empty()) sight.strokes = std::make_shared<const ProjectedStrokes>(std::move(strokes));
}

/// What strokes have changed since the picture begun before; `margin`: Sight::strokeMargin.
void compareStrokes(Sight& sight, const Sight* before, int margin) {
  sight.strokeMargin = margin;
  if (before) sight.strokesBefore = before->strokes;
  if (*sight.strokes == *sight.strokesBefore)
    sight.strokes = sight.strokesBefore;
  else
    sight.changed = changedRegions(*sight.strokesBefore, *sight.strokes, sight.view.size, margin);
}

/// The camera as a part sees the volume: moved back by what the part is moved.
Camera seenBy(const ExplodedPart& part, Camera camera) {
  camera.eye -= part.translation;
  camera.target -= part.translation;
  return camera;
}

ExplodedRays explode(const MethodStages::Explosion& explosion, const GpuScene& gpu, const Sight& sight) {
  using Stretch = FocusLayerPass::Stretch;
  const Grid& grid = gpu.grid();
  const RayFrame& rays = sight.rays;
  ExplodedRays exploded{.view = {explosion, grid, middleOf(gpu), sight.view.camera},
                        .hasFocus = gpu.focusKind() != FocusIndex::Kind::None};
  const auto add = [&](Stretch shown) {
    for (const ExplodedPart& part : exploded.view.parts()) {
      Clip clip = rays.clip();
      clip.kept.insert(clip.kept.end(), part.kept.begin(), part.kept.end());
      const RayFrame moved(seenBy(part, sight.view.camera), sight.view.size, grid, std::move(clip), gpu.refinement());
      exploded.stretches.push_back({shown, moved, rays.distance() - moved.distance()});
    }
  };
  add(Stretch::Before);
  if (exploded.hasFocus) {
    exploded.stretches.push_back({Stretch::InFocus, rays, 0.0});
    add(Stretch::Behind);
  }
  return exploded;
}

/// How rays are sampled where not every picture's way of it can draw the scene.
FocusLayerPass::Sampling samplingFor(const Frame& frame, const GpuScene& gpu) {
  FocusLayerPass::Sampling sampling = samplingOf(frame.view(), gpu.grid(), frame.look().shading.enabled);
  // Only the integral within a bound knows what of a ray's opacity lies before a point. Its rays end at a quarter of
  // the bound, and so at the tolerance, as others do.
  if (fadingOf(frame.look()) && !sampling.maxError) {
    sampling.maxError = 4.0 * sampling.tolerance;
    sampling.roughSteps = true;
  }
  // The focus alone needs that integral, too. Half of the bound is left for what lies beneath it.
  if (maximumOf(frame.look())) sampling.maxError = 0.5 * sampling.maxError.value_or(FocusLayerPass::usualBound);
  // Rays that see nothing on a part of their way need that integral, too: it knows where a ray ends. Each of the two
  // parts gets half of the bound.
  if (frame.other || gpu.exemptLabels().any())
    sampling.maxError = 0.5 * sampling.maxError.value_or(FocusLayerPass::usualBound);
  // A ray crosses each plane of an exploded view once, so that it meets one part more than there are planes; a focus
  // parts one of them.
  if (frame.exploded)
    sampling.maxError = sampling.maxError.value_or(FocusLayerPass::usualBound) /
                        (explosionOf(frame.look())->planes + (frame.exploded->hasFocus ? 3 : 1));
  if (!sampling.maxError)
    if (const auto chosen = gpu.chosenBound(frame.scene, frame.view())) sampling = {.maxError = *chosen / 255.0};
  return sampling;
}

}  // namespace

Frame frameOf(const Scene& scene, const View& view, const GpuScene& gpu, const Frame* before) {
  const Look& look = scene.look;
  Frame frame{.scene = scene, .own = sightOf(look, gpu, view)};
  frame.background = glm::vec3(look.background);
  frame.backgroundRise = glm::vec3(backgroundRise(look));
  frame.drawn = gpu.versions();
  if (const auto explosion = explosionOf(look)) frame.exploded = explode(*explosion, gpu, frame.own);
  frame.hasCutaway = hasCutaway(scene);
  if (frame.hasCutaway) {
    frame.method = stagesOf(look.method);
    frame.hasContextLayer = look.contextLayer.strength > 0.0;
    if (const auto opening = openingOf(view, look.cutaway, middleOf(gpu)))
      frame.other =
          sightOf(look, gpu, {.camera = opening->camera, .size = opening->size, .pixelScale = opening->pixelScale});
    cutFor(frame.other ? *frame.other : frame.own, look, gpu);
  }
  frame.sampling = samplingFor(frame, gpu);
  const int margin = FocusLayerPass::reach(frame.sampling);
  compareStrokes(frame.own, before ? &before->own : nullptr, margin);
  if (frame.other) compareStrokes(*frame.other, before && before->other ? &*before->other : nullptr, margin);
  return frame;
}

}  // namespace fenestra
