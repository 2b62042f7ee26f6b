#include "rendering/vocabulary/MethodStages.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fenestra {

MethodStages MethodStages::withoutOpening() {
  MethodStages stages;
  stages.start = Start::Entry;
  stages.hasWidth = stages.hasBorder = false;
  return stages;
}

MethodStages MethodStages::onCones(double angle, bool onSilhouette) {
  MethodStages stages;
  stages.start = Start::Cones;
  stages.hasWidth = false;
  stages.slope = 1.0 / std::tan(angle * std::numbers::pi / 180.0);
  stages.onSilhouette = onSilhouette;
  return stages;
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
