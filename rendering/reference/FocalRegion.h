#pragma once
// A focal region in double precision, as MethodStages::Fading::Region (rendering/scene/Method.h) defines it.

#include <algorithm>
#include <cmath>
#include <vector>

#include "rendering/scene/Method.h"

namespace fenestra::reference {

class FocalRegion {
 public:
  FocalRegion(const MethodStages::Fading::Region& region, glm::dvec3 middle) : region_(region), middle_(middle) {}

  /// δ: mm that a place in the world lies outside.
  double distance(glm::dvec3 world) const {
    const glm::dvec3 from = world - middle_;
    if (region_.shape == FocalShape::Sphere) return std::max(glm::length(from) - region_.size, 0.0);
    return glm::length(glm::max(glm::abs(from) - region_.size, 0.0));
  }

  /// What a distance leaves of contours.
  double shareAt(double distance) const { return std::exp2(-distance / region_.fallOff); }

  /// Appends where a straight path, 0 at `from` and 1 at `to`, may enter or leave the region, and where the distance
  /// has a kink.
  void appendCrossings(glm::dvec3 from, glm::dvec3 to, std::vector<double>& places) const {
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

 private:
  MethodStages::Fading::Region region_;
  glm::dvec3 middle_;
};

}  // namespace fenestra::reference
