// Stages 1 to 4 of the chain: where rays meet context and focus, and where they start to see. Which of them run, the
// scene's method says (rendering/scene/Method.h).

#include <algorithm>
#include <cmath>

#include "rendering/PassChain.h"
#include "rendering/scene/EdgeRays.h"

namespace fenestra {
namespace {

/// Distance maps reach this far (rendered pixels) or the next power of two beyond what the widths need: a slider that
/// moves within it leaves the map as it is.
constexpr int leastDistanceRange = 64;

int distanceRange(glm::dvec2 widths, glm::ivec2 size) {
  // Half a pixel more than the border's rim, which is anti-aliased.
  const double needed = std::min(widths.x + widths.y + 1.0, std::hypot(size.x, size.y));
  int range = leastDistanceRange;
  while (range < needed) range *= 2;
  return range;
}

}  // namespace

void PassChain::findHitPoints() {
  const GpuScene::Versions& version = gpu->versions();
  const View& view = frame->view;
  addIfStale(
      Pass::HitPoints, hits,
      HitKey{version.volume, version.focus, version.gaps, version.importance, view.camera, view.size, rays->clip()}, {},
      [&](Regions) { hitPointPass.run(steps, *gpu, *rays, sized(hitPoints, gl::Format::RG32F, view.size)); });
}

void PassChain::findImportantHits() {
  const std::vector<KeptLabels>& levels = gpu->importance();
  if (levels.empty()) return dropImportance();
  using Found = ImportanceKey::Found;
  const bool onCones = frame->method.start == MethodStages::Start::Cones;
  const Found found = opening ? Found::Topmost : onCones ? Found::Cones : Found::Surfaces;
  importantHits.resize(found == Found::Cones ? levels.size() : 0);
  addIfStale(Pass::Importance, importance, ImportanceKey{hits.version(), found}, {}, [&](Regions) {
    gl::Texture& opened = sized(openedHits, gl::Format::RG32F, rays->size());
    if (found == Found::Topmost) importancePass.run(steps, *gpu, levels.back(), *rays, hitPoints, opened);
    for (std::size_t i = 0; i < levels.size() && found != Found::Topmost; ++i) {
      gl::Texture& made = found == Found::Cones ? sized(importantHits[i], gl::Format::RG32F, rays->size()) : opened;
      importancePass.run(steps, *gpu, levels[i], *rays, hitPoints, made, found == Found::Surfaces && i > 0);
    }
  });
}

void PassChain::shapeOpening() {
  if (opening) return;
  if (frame->method.start == MethodStages::Start::Cones) {
    dropFill();
    standCones();
  } else {
    dropCones();
    fillFocusHits();
  }
}

void PassChain::fillFocusHits() {
  addIfStale(Pass::PullPush, fill, FillKey{hits.version()}, {}, [&](Regions) {
    pullPushPass.run(steps, gpu->schedule(), hitsToOpen(), sized(focusFilled, gl::Format::R32F, rays->size()));
  });
}

void PassChain::standCones() {
  const ConePass::Cones wanted{frame->method.slope, frame->method.onSilhouette};
  addIfStale(Pass::Cones, cones, ConeKey{hits.version(), wanted}, {}, [&](Regions) {
    const gl::Region around = nearFocus(1.0).value_or(gl::Region());
    gl::Texture& starts = sized(coneStart, gl::Format::R32F, rays->size());
    if (importantHits.empty()) conePass.run(steps, gpu->schedule(), *rays, hitPoints, around, wanted, starts);
    for (std::size_t i = 0; i < importantHits.size(); ++i)
      conePass.run(steps, gpu->schedule(), *rays, importantHits[i], around, wanted, starts,
                   ConePass::Level{openedHits, i == 0});
  });
}

void PassChain::mapDistances() {
  if (opening) return;
  // Between pixels the map is read up to a pixel further.
  const double between = hasSmoothEdges(frame->scene.look, frame->view) ? edges::distanceBeyond - 1.0 : 0.0;
  const int range = distanceRange(widths + glm::dvec2(between, 0.0), frame->view.size);
  const gl::Texture* opened = coneStart ? &coneStart : nullptr;
  addIfStale(Pass::DistanceMap, distance, DistanceKey{hits.version(), opened ? cones.version() : 0, range}, {},
             [&](Regions) {
               distanceMapPass.run(steps, gpu->schedule(), hitsToOpen(), range,
                                   sized(distances, gl::Format::R32F, frame->view.size), opened);
             });
}

void PassChain::startRays() {
  if (opening) return startRaysApart();
  const glm::ivec2 size = frame->view.size;
  const gl::Texture* given = coneStart ? &coneStart : nullptr;
  const RayStartKey key{hits.version(), given ? 0 : fill.version(), distance.version(), given ? cones.version() : 0,
                        widths.x};
  const RayStartPass::Inputs inputs{hitsToOpen(), focusFilled, distances, widths.x, 0.0, given};
  if (frame->strokes.empty())
    releaseEdits();
  else
    addIfStale(Pass::EditMap, edits, key, frame->changed, [&](Regions regions) {
      gl::Texture& map = sized(editMap, gl::Format::RG32F, size);
      editMapPass.run(steps, gpu->schedule(), *rays, inputs, frame->strokes, regions, map);
    });
  if (const auto& last = start.key(); last && last->hits == key.hits && last->cones == 0 && key.cones == 0)
    frame->moved = std::max(last->openWidth, key.openWidth) + 1.0;
  addIfStale(
      Pass::RayStart, start, key, frame->changed,
      [&](Regions regions) {
        rayStartPass.run(steps, gpu->schedule(), *rays, inputs, editMap ? &editMap : nullptr, regions,
                         sized(rayStart, gl::Format::R32F, size));
      },
      frame->moved ? nearFocus(*frame->moved) : std::nullopt);
}

RemovedPass::Opening PassChain::cutOpening() const {
  return {*opening->rays,           opening->hitsToOpen(), opening->cutSurface(),
          opening->distances,       opening->rayStart,     opening->editMap ? &opening->editMap : nullptr,
          widths.x + widths.y + 1.0};
}

double PassChain::shortestVoxelSide() const {
  const glm::dvec3 spacing = gpu->grid().spacing;
  return std::min({spacing.x, spacing.y, spacing.z});
}

void PassChain::startRaysApart() {
  const glm::ivec2 size = frame->view.size;
  const bool holes = hasHoles();
  const RemovedPass::Opening cut = cutOpening();
  if (!opening->editMap) editMap = {};
  addIfStale(Pass::RayStart, removed,
             RemovedKey{hits.version(), opening->start.version(), *frame->opening, widths,
                        opening->strokes.value_or(ProjectedStrokes()), holes},
             {}, [&](Regions) {
               const RemovedPass::Outputs outputs{sized(rayStart, gl::Format::R32F, size),
                                                  sized(hole, gl::Format::RG32F, size),
                                                  sized(distances, gl::Format::R32F, size),
                                                  cut.editMap ? &sized(editMap, gl::Format::RG32F, size) : nullptr};
               removedPass.run(steps, gpu->schedule(), *rays, hitsToOpen(), cut, holes, shortestVoxelSide(),
                               sized(faces, gl::Format::RGBA32F, opening->rays->size()), outputs);
             });
}

/// A plain volume rendering keeps none of the cutaway's images, an exploded view the hits of its focus.
void PassChain::dropCutaway() {
  for (gl::Texture* texture : {&distances, &rayStart}) *texture = {};
  dropFill();
  dropCones();
  dropImportance();
  distanceMapPass.release();
  releaseEdits();
  distance.forget();
  start.forget();
  if (explodesAroundFocus()) return;
  hitPoints = {};
  hits.forget();
}

}  // namespace fenestra
