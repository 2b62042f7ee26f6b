#include "rendering/Picking.h"

#include <algorithm>

#include "rendering/stages/Images.h"

namespace fenestra {

bool Picking::shows(glm::ivec2 pixel) const {
  return chain_.picture() && glm::all(glm::greaterThanEqual(pixel, glm::ivec2(0))) &&
         glm::all(glm::lessThan(pixel, glm::ivec2(chain_.picture().size())));
}

bool Picking::movesContext() const {
  const Frame* frame = chain_.frame();
  return frame && (frame->exploded || frame->peeled);
}

glm::vec2 Picking::traceHit(const RayFrame& rays, glm::ivec2 pixel) {
  Steps single;
  hitPointPass_.run(single, chain_.gpu(), rays, sized(hit_, gl::Format::RG32F, glm::ivec2(1)), pixel);
  single.advance();
  return hit_.readTexel(glm::ivec2(0));
}

glm::vec2 Picking::hitAt(glm::ivec2 pixel) {
  const Output hits = chain_.stages().starts.hits();
  // A plain volume rendering has no hits.
  return hits ? glm::vec2(hits.image.readTexel(pixel)) : traceHit(chain_.frame()->own.rays, pixel);
}

float Picking::startAt(glm::ivec2 pixel) {
  const Output starts = chain_.stages().starts.starts();
  return starts ? starts.image.readTexel(pixel).x : hitAt(pixel).x;
}

float Picking::editAt(glm::ivec2 pixel) const {
  const Output edits = chain_.stages().starts.edits();
  return edits ? edits.image.readTexel(pixel).x : 0.0f;
}

std::optional<PickedPlace> Picking::place(glm::dvec2 pixel) {
  const glm::ivec2 at(glm::floor(pixel));
  if (!shows(at)) return std::nullopt;
  const Frame& frame = *chain_.frame();
  const auto placeAt = [&](float position) { return frame.own.rays.worldPosition(glm::dvec2(at) + 0.5, position); };
  const glm::dvec3 ray = glm::normalize(placeAt(1.0f) - placeAt(0.0f));
  if (frame.exploded) {
    const std::optional<glm::dvec3> inPart = pickExploded(at);
    return inPart ? std::optional(PickedPlace{*inPart, ray}) : std::nullopt;
  }
  const float position = startAt(at);
  if (!isSomething(position)) return std::nullopt;
  return frame.peeled ? pickPeeled(placeAt(position), ray) : PickedPlace{placeAt(position), ray};
}

std::optional<glm::dvec3> Picking::pickExploded(glm::ivec2 pixel) {
  const Frame& frame = *chain_.frame();
  const auto placeOn = [&](const RayFrame& through, float s) {
    return through.worldPosition(glm::dvec2(pixel) + 0.5, s);
  };
  const float inFocus = traceHit(frame.own.rays, pixel).y;
  for (const auto& [shown, through, fromPicture] : frame.exploded->stretches) {
    if (shown != FocusLayerPass::Stretch::Before) break;
    const glm::vec2 hit = traceHit(through, pixel);
    if (!isSomething(hit.x)) continue;
    if (isSomething(inFocus) && inFocus + fromPicture <= hit.x) break;
    // The ray meets the focus first in the volume, but a part does not show it: the ray looks into the hollow.
    if (hit.x == hit.y) return std::nullopt;
    return placeOn(through, hit.x);
  }
  if (!isSomething(inFocus)) return std::nullopt;
  return placeOn(frame.own.rays, inFocus);
}

std::optional<PickedPlace> Picking::pickPeeled(glm::dvec3 seen, glm::dvec3 ray) const {
  const PeeledScene& peeled = *chain_.frame()->peeled;
  // Faces are as soft as a voxel, and the surface lies somewhere in them: the first place from there on that shows
  // something is the one.
  const glm::dvec3 spacing = chain_.gpu().grid().spacing;
  const double voxel = std::min({spacing.x, spacing.y, spacing.z});
  constexpr int mostSteps = 8, stepsPerVoxel = 4;
  for (int i = 0; i <= mostSteps; ++i) {
    const glm::dvec3 at = seen + (i * voxel / stepsPerVoxel) * ray;
    const auto source = peeled.sourceOf(at);
    if (!source) continue;
    const auto beyond = peeled.sourceOf(at + 0.5 * voxel * ray);
    const glm::dvec3 on = beyond ? *beyond - *source : glm::dvec3(0.0);
    // Where the ray leaves the part within half a voxel, it has no direction of its own there.
    return PickedPlace{*source, glm::length(on) > 0.0 && glm::length(on) < 2.0 * voxel ? glm::normalize(on) : ray};
  }
  return std::nullopt;
}

glm::dvec3 Picking::shownAt(glm::dvec3 world) const {
  const Frame* frame = chain_.frame();
  if (frame && frame->peeled) return frame->peeled->shownAt(world);
  return frame && frame->exploded ? explodedPosition(world) : world;
}

glm::dvec3 Picking::explodedPosition(glm::dvec3 world) const {
  const GpuScene& gpu = chain_.gpu();
  const Frame& frame = *chain_.frame();
  const Grid& grid = gpu.grid();
  const glm::ivec3 cell(glm::floor(glm::clamp(glm::dvec3(grid.indexFromWorld() * glm::dvec4(world, 1.0)) + 1.0,
                                              glm::dvec3(-1.0), glm::dvec3(grid.dims + 1))));
  const bool isInside =
      glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) && glm::all(glm::lessThanEqual(cell, grid.dims));
  // Within a voxel of the focus, which stays in its place. Another view may have brought the shared scene to a state
  // without a focus since this picture was drawn.
  const bool hasFocus = frame.explodesAroundFocus() && gpu.focusKind() != FocusIndex::Kind::None;
  if (hasFocus && isInside && gpu.focus().holds(cell)) return world;
  for (const ExplodedPart& part : frame.exploded->view.parts())
    if (keeps(part.kept, world)) return world + part.translation;
  return world;
}

std::optional<BrushPoint> Picking::brushPoint(glm::dvec2 pixel, BrushMode mode, std::optional<glm::dvec3> before) {
  const glm::ivec2 at(glm::floor(pixel));
  if (!shows(at) || movesContext()) return std::nullopt;
  const Sight& own = chain_.frame()->own;
  const RayFrame& rays = own.rays;
  const glm::vec2 hit = hitAt(at);
  const float context = hit.x, start = startAt(at);
  float position = context;
  if (mode == BrushMode::Open) {
    position = start;
    if (isSomething(position)) position = std::max(context, position - std::max(0.0f, editAt(at)));
  }
  BrushPoint point;
  if (isSomething(position)) {
    // The surface under the pixel's centre, at the pixel's own place.
    const double depth = rays.depthOf(rays.worldPosition(glm::dvec2(at) + 0.5, position));
    point.anchor = rays.worldPositionAtDepth(pixel, depth);
    point.meetsFocus = isSomething(hit.y);
    point.removed = isSomething(start) ? std::max(0.0f, start - context) : 0.0;
    point.beforeFocus = point.meetsFocus && isSomething(start) ? std::max(0.0f, hit.y - start) : 0.0;
  } else if (before) {
    point.hitsContext = false;
    point.anchor = rays.worldPositionAtDepth(pixel, rays.depthOf(*before));
  } else {
    return std::nullopt;
  }
  point.pixelSize = rays.pixelSize(rays.depthOf(point.anchor)) * own.view.pixelScale;
  return point;
}

}  // namespace fenestra
