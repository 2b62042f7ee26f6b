#include "rendering/viewpoints/Habits.h"

#include <algorithm>

#include "rendering/viewpoints/ScanShape.h"

namespace fenestra::placement {
namespace {

constexpr double cutEndCost = 0.3, lyingCost = 0.1, edgeOnCost = 10.0, farSideCost = 0.1;
constexpr double mostThroughCutEnd = 0.5;
constexpr double enough = 2.0 / 3.0;  ///< of what a view through a cut end shows
constexpr double partOfC2 = 0.5;

}  // namespace

Awkwardness awkwardness(const ScanShape& shape, glm::dvec3 direction) {
  return {shape.throughCutEnd(direction), direction.z * direction.z, shape.edgeOn(direction), shape.farSide(direction)};
}

double costOf(const Awkwardness& view, const Habits& habits) {
  return (habits.avoidCutEnds ? cutEndCost * view.throughCutEnd : 0.0) +
         (habits.uprightFirst ? lyingCost * view.lying : 0.0) +
         (habits.flatFromFront ? edgeOnCost * view.edgeOn : 0.0) +
         (habits.nearSideFirst ? farSideCost * view.farSide : 0.0);
}

double costOfPair(double cost1, double cost2) { return std::min(cost1, cost2) + partOfC2 * std::max(cost1, cost2); }

void CutEndRule::add(const Awkwardness& view, double shows) {
  if (view.throughCutEnd <= mostThroughCutEnd) othersShow_ = std::max(othersShow_, shows);
}

bool CutEndRule::admits(const Awkwardness& view, double shows) const {
  return !applies_ || view.throughCutEnd <= mostThroughCutEnd || othersShow_ < enough * shows;
}

}  // namespace fenestra::placement
