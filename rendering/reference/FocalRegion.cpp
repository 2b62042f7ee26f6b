#include "rendering/reference/FocalRegion.h"

#include <algorithm>
#include <cmath>

#include "rendering/reference/Cells.h"

namespace fenestra::reference {

FocalRegion::FocalRegion(const MethodStages::Fading::Region& region, const Scene& scene)
    : region_(region), dims_(scene.volume->grid.dims), indexFromWorld_(scene.volume->grid.indexFromWorld()) {
  if (region.shape == FocalShape::Distance)
    distances_ = focusDistances(scene);
  else
    middle_ = focusCentre(scene);
}

double FocalRegion::distance(glm::dvec3 world) const {
  if (region_.shape == FocalShape::Distance) return std::max(fromFocus(world) - region_.size, 0.0);
  const glm::dvec3 from = world - middle_;
  if (region_.shape == FocalShape::Sphere) return std::max(glm::length(from) - region_.size, 0.0);
  return glm::length(glm::max(glm::abs(from) - region_.size, 0.0));
}

double FocalRegion::shareAt(double distance) const { return std::exp2(-distance / region_.fallOff); }

void FocalRegion::appendCrossings(glm::dvec3 from, glm::dvec3 to, std::vector<double>& places) const {
  if (region_.shape == FocalShape::Distance) {
    const auto along = [&](double u) { return fromFocus(glm::mix(from, to, u)); };
    const Cubic cubic = through(along(0.0), along(1.0 / 3.0), along(2.0 / 3.0), along(1.0));
    return reference::appendCrossings(cubic, monotoneStops(cubic), region_.size, places);
  }
  const glm::dvec3 start = from - middle_, step = to - from;
  const auto append = [&](double place) {
    if (place > 0.0 && place < 1.0) places.push_back(place);
  };
  if (region_.shape == FocalShape::Box) {
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-region_.size, region_.size}) append((side - start[axis]) / step[axis]);
    return;
  }
  // ‖start + u step‖ = size
  const double square = glm::dot(step, step), half = glm::dot(start, step);
  const double rest = half * half - square * (glm::dot(start, start) - region_.size * region_.size);
  if (!(rest > 0.0)) return;
  append((-half - std::sqrt(rest)) / square);
  append((-half + std::sqrt(rest)) / square);
}

double FocalRegion::fromFocus(glm::dvec3 world) const {
  const glm::dvec3 index =
      glm::clamp(glm::dvec3(indexFromWorld_ * glm::dvec4(world, 1.0)), glm::dvec3(0.0), glm::dvec3(dims_ - 1));
  const SampledLattice& lattice = distances_.lattice;
  const glm::dvec3 place = index / glm::dvec3(lattice.step);
  const glm::ivec3 point = glm::min(glm::ivec3(place), lattice.points - 2);
  const glm::dvec3 within = place - glm::dvec3(point);
  double sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 corner(i & 1, i >> 1 & 1, i >> 2);
    const glm::dvec3 weight = glm::mix(1.0 - within, within, glm::dvec3(corner));
    sum += weight.x * weight.y * weight.z * distances_.at(point + corner);
  }
  return sum;
}

}  // namespace fenestra::reference
