// Exploded views (rendering/scene/Explosion.h): the stretches of their rays; and of them and of peeled volumes
// (rendering/scene/Peel.h), where a place of the picture is in the volume.

#include <algorithm>

#include "rendering/PassChain.h"

namespace fenestra {
namespace {

/// The camera as a part sees the volume: moved back by what the part is moved.
Camera seenBy(const ExplodedPart& part, Camera camera) {
  camera.eye -= part.translation;
  camera.target -= part.translation;
  return camera;
}

/// Smallest region that holds both.
gl::Region around(const gl::Region& a, const gl::Region& b) {
  const glm::ivec2 first = glm::min(a.origin, b.origin), end = glm::max(a.origin + a.size, b.origin + b.size);
  return {first, end - first};
}

}  // namespace

void PassChain::explode() {
  exploded.reset();
  stretches.clear();
  const auto explosion = explosionOf(frame->scene.look);
  if (!explosion || onlyStarts) return;
  const Grid& grid = gpu->grid();
  const View& view = frame->view;
  exploded.emplace(*explosion, grid, gpu->focus().centre(grid).value_or(grid.centre()), view.camera);
  using Stretch = FocusLayerPass::Stretch;
  const bool hasFocus = explodesAroundFocus();
  const auto add = [&](Stretch shown) {
    for (const ExplodedPart& part : exploded->parts()) {
      Clip clip = rays->clip();
      clip.kept.insert(clip.kept.end(), part.kept.begin(), part.kept.end());
      const RayFrame moved(seenBy(part, view.camera), view.size, grid, std::move(clip), gpu->refinement());
      stretches.push_back({shown, moved, rays->distance() - moved.distance()});
    }
  };
  add(Stretch::Before);
  if (hasFocus) {
    stretches.push_back({Stretch::InFocus, *rays, 0.0});
    add(Stretch::Behind);
  }
  // A ray crosses each plane once, so that it meets one part more than there are planes; a focus parts one of them.
  frame->sampling.maxError =
      frame->sampling.maxError.value_or(FocusLayerPass::usualBound) / (explosion->planes + (hasFocus ? 3 : 1));
}

gl::Region PassChain::nearVolume(double reach) const {
  const IndexBox all{glm::ivec3(0), gpu->grid().dims - 1};
  gl::Region seen = rays->around(all, reach);
  for (const FocusLayerPass::ExplodedStretch& stretch : stretches) seen = around(seen, stretch.rays.around(all, reach));
  return seen;
}

std::optional<glm::dvec3> PassChain::pickExploded(glm::ivec2 pixel) {
  const auto hitOn = [&](const RayFrame& through) {
    Steps single;
    hitPointPass.run(single, *gpu, through, sized(pickedHit, gl::Format::RG32F, glm::ivec2(1)), pixel);
    single.advance();
    return pickedHit.readTexel(glm::ivec2(0));
  };
  const auto placeOn = [&](const RayFrame& through, float s) {
    return through.worldPosition(glm::dvec2(pixel) + 0.5, s);
  };
  const float inFocus = hitOn(*rays).y;
  for (const auto& [shown, through, fromPicture] : stretches) {
    if (shown != FocusLayerPass::Stretch::Before) break;
    const glm::vec2 hit = hitOn(through);
    if (!isSomething(hit.x)) continue;
    if (isSomething(inFocus) && inFocus + fromPicture <= hit.x) break;
    // What is first met of the volume is the focus, which is not there: the ray looks into the hollow.
    if (hit.x == hit.y) return std::nullopt;
    return placeOn(through, hit.x);
  }
  if (!isSomething(inFocus)) return std::nullopt;
  return placeOn(*rays, inFocus);
}

std::optional<PickedPlace> PassChain::pickPeeled(glm::dvec3 seen, glm::dvec3 ray) const {
  // Faces are as soft as a voxel, and the surface lies somewhere in them: from there on, what is first brought there.
  const glm::dvec3 spacing = gpu->grid().spacing;
  const double voxel = std::min({spacing.x, spacing.y, spacing.z});
  constexpr int mostSteps = 8, stepsPerVoxel = 4;
  for (int i = 0; i <= mostSteps; ++i) {
    const glm::dvec3 at = seen + (i * voxel / stepsPerVoxel) * ray;
    const auto source = peeled->sourceOf(at);
    if (!source) continue;
    const auto beyond = peeled->sourceOf(at + 0.5 * voxel * ray);
    const glm::dvec3 on = beyond ? *beyond - *source : glm::dvec3(0.0);
    // Where the ray leaves the part within half a voxel, it has no direction of its own there.
    return PickedPlace{*source, glm::length(on) > 0.0 && glm::length(on) < 2.0 * voxel ? glm::normalize(on) : ray};
  }
  return std::nullopt;
}

glm::dvec3 PassChain::movedPosition(glm::dvec3 world) const {
  if (peeled) return peeled->shownAt(world);
  if (!exploded) return world;
  const Grid& grid = gpu->grid();
  const glm::ivec3 cell(glm::floor(glm::clamp(glm::dvec3(grid.indexFromWorld() * glm::dvec4(world, 1.0)) + 1.0,
                                              glm::dvec3(-1.0), glm::dvec3(grid.dims + 1))));
  const bool isInside =
      glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) && glm::all(glm::lessThanEqual(cell, grid.dims));
  if (explodesAroundFocus() && isInside && gpu->focus().holds(cell)) return world;
  for (const ExplodedPart& part : exploded->parts())
    if (keeps(part.kept, world)) return world + part.translation;
  return world;
}

}  // namespace fenestra
