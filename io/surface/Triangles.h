#pragma once
// A surface of triangles, and how it is made and written.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra::io {

/// Triangles are counter-clockwise seen from outside; points are LPS mm.
struct Surface {
  std::vector<glm::dvec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// Enclosed volume in mm³ (divergence theorem); cavities count negative.
  double volume() const {
    // From a point on the surface: far from the origin, large terms would cancel.
    const glm::dvec3 centre = points.empty() ? glm::dvec3(0.0) : points.front();
    double sixfold = 0.0;
    for (const auto& [a, b, c] : triangles)
      sixfold += glm::dot(points[a] - centre, glm::cross(points[b] - centre, points[c] - centre));
    return sixfold / 6.0;
  }
};

struct SurfaceOptions {
  bool smooth = true;  ///< false: the level set as it is, with the steps of the voxels
};

/// The axes that a file's coordinates are in, mm. RAS has x and y reversed.
enum class SurfaceFrame : std::uint8_t { Lps, Ras };

}  // namespace fenestra::io
