#include "rendering/settings/Method.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fenestra {
namespace {

MethodStages cones(double angle, bool onSilhouette) {
  MethodStages stages;
  stages.start = MethodStages::Start::Cones;
  stages.hasWidth = false;
  stages.slope = 1.0 / std::tan(angle * std::numbers::pi / 180.0);
  stages.onSilhouette = onSilhouette;
  return stages;
}

}  // namespace

MethodStages stagesOf(const Method& method) {
  switch (method.kind) {
    case MethodKind::Adaptive:
      break;
    case MethodKind::Cone:
      return cones(method.coneAngle, false);
    case MethodKind::Importance: {
      MethodStages stages;
      if (method.importance == ImportanceMode::Maximum) stages = cones(method.importanceAngle, true);
      stages.hasLevels = true;
      if (method.importance == ImportanceMode::Maximum) return stages;
      stages.hasWidth = false;
      stages.faintOpacity = method.importanceOpacity;
      stages.sparseness = method.sparseness;
      return stages;
    }
    case MethodKind::ClearView: {
      MethodStages stages;
      stages.hasWidth = stages.hasBorder = false;
      stages.lens = {method.lensPlace, method.lensFade, 0.01 * method.lensRadius, method.lensBends, method.lensRim};
      return stages;
    }
    case MethodKind::ContextPreserving: {
      MethodStages stages;
      stages.start = MethodStages::Start::Entry;
      stages.hasWidth = stages.hasBorder = false;
      stages.fading = {method.fadeReach, method.fadeSharpness};
      return stages;
    }
    case MethodKind::FocalRegion: {
      MethodStages stages;
      stages.start = MethodStages::Start::Entry;
      stages.hasWidth = stages.hasBorder = false;
      MethodStages::Fading around;
      around.region = {method.focalShape, method.focalSize, method.focalFallOff};
      stages.fading = around;
      return stages;
    }
    case MethodKind::Walls: {
      MethodStages stages;
      stages.walls = {method.wallPlacement, method.wallAxial, method.wallSagittal, method.wallCoronal,
                      method.wallOutlines};
      return stages;
    }
    case MethodKind::Explode: {
      MethodStages stages;
      stages.start = MethodStages::Start::Entry;
      stages.hasWidth = stages.hasBorder = false;
      if (method.explosion > 0.0)
        stages.explosion = {method.explosion, 1 + static_cast<int>(method.explosionPlanes), method.explosionAxes};
      return stages;
    }
    case MethodKind::Sculpt:
    case MethodKind::Bend: {
      MethodStages stages;
      stages.start = MethodStages::Start::Entry;
      stages.hasWidth = stages.hasBorder = false;
      return stages;
    }
    case MethodKind::Peel: {
      MethodStages stages;
      stages.start = MethodStages::Start::Entry;
      stages.hasWidth = stages.hasBorder = false;
      if (method.peel > 0.0)
        stages.peel = {method.peel,      method.peelSide,   method.peelTurn,
                       method.peelDepth, method.peelRadius, method.peelMargin};
      return stages;
    }
    case MethodKind::Selection: {
      MethodStages stages;
      MethodStages::Fading ghosted;
      ghosted.ghost = {method.ghostStrength, 0.01 * method.ghostEdge, method.ghostOutline};
      stages.fading = ghosted;
      return stages;
    }
  }
  return {};
}

double radiusOf(const MethodStages::Lens& lens, const Grid& grid) {
  const glm::dvec3 sides = glm::dvec3(grid.dims) * grid.spacing;
  return lens.radius * std::max({sides.x, sides.y, sides.z});
}

double faintShare(Sparseness sparseness, double opacity, int i, int j) {
  if (sparseness != Sparseness::ScreenDoor) return opacity;
  // Bayer's matrix: the bits of x ⊕ y and of y in turns, reversed, so that the lowest ones weigh most.
  const auto x = static_cast<unsigned>(i), y = static_cast<unsigned>(j);
  unsigned rank = 0;
  for (unsigned bit = 0; bit < 3; ++bit) rank = (rank << 2) | ((((x ^ y) >> bit) & 1u) << 1) | ((y >> bit) & 1u);
  return (rank + 0.5) / 64.0 < opacity ? 1.0 : 0.0;
}

}  // namespace fenestra
