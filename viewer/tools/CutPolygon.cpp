#include "viewer/tools/CutPolygon.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fenestra::viewer {

std::vector<glm::dvec3> cutPolygon(const Grid& grid, const HalfSpace& plane) {
  const std::array<glm::dvec3, 8> corners = grid.corners();
  std::vector<glm::dvec3> points;
  for (std::size_t from = 0; from < 8; ++from)
    for (std::size_t bit = 1; bit < 8; bit *= 2) {
      if (from & bit) continue;
      const double a = plane.distance(corners[from]), b = plane.distance(corners[from | bit]);
      if ((a < 0.0) != (b < 0.0)) points.push_back(glm::mix(corners[from], corners[from | bit], a / (a - b)));
    }
  if (points.size() < 3) return {};
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& point : points) middle += point / static_cast<double>(points.size());
  const glm::dvec3 u = glm::normalize(points[0] - middle), v = glm::cross(plane.normal, u);
  const auto angle = [&](glm::dvec3 p) { return std::atan2(glm::dot(p - middle, v), glm::dot(p - middle, u)); };
  std::sort(points.begin(), points.end(), [&](glm::dvec3 a, glm::dvec3 b) { return angle(a) < angle(b); });
  return points;
}

}  // namespace fenestra::viewer
