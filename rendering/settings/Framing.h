#pragma once
// What a camera is to have in its picture.

#include <vector>

#include "rendering/volume/Grid.h"

namespace fenestra {

/// Points that enclose what is to be seen, and the point that a camera turns around.
struct Framing {
  glm::dvec3 centre{0.0};          ///< world, mm
  std::vector<glm::dvec3> points;  ///< world, mm; what is to be seen lies in their convex hull

  /// All of a grid.
  Framing(const Grid& grid);  // NOLINT(google-explicit-constructor): a camera frames a grid as readily
  Framing(glm::dvec3 around, std::vector<glm::dvec3> hull) : centre(around), points(std::move(hull)) {}

  /// mm from the centre to the farthest point.
  double radius() const;
};

}  // namespace fenestra
