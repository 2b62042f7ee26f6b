#include "rendering/viewpoints/SurfaceCurvature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "rendering/volume/Threads.h"

namespace fenestra::placement {
namespace {

constexpr std::size_t nearestPoints = 12;
/// Width of a class of curvatures, of asinh of what it is on the sphere of equal area.
constexpr double classWidth = 0.5;

/// The nearest points to one on its side of the surface, without itself.
std::vector<std::size_t> neighboursOf(std::size_t point, const std::vector<glm::dvec3>& positions,
                                      const std::vector<glm::dvec3>& normals) {
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t other = 0; other < positions.size(); ++other) {
    if (other == point || glm::dot(normals[other], normals[point]) <= 0.0) continue;
    const glm::dvec3 away = positions[other] - positions[point];
    near.emplace_back(glm::dot(away, away), other);
  }
  const std::size_t count = std::min(nearestPoints, near.size());
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
  std::vector<std::size_t> neighbours;
  for (std::size_t i = 0; i < count; ++i) neighbours.push_back(near[i].second);
  return neighbours;
}

/// det S with S = (a b; b c) that minimises Σ |S u − d|² over the neighbours, u and d being Δx and Δn in the tangent
/// plane: a linear system in (a, b, c).
double curvatureAt(std::size_t point, const std::vector<glm::dvec3>& positions,
                   const std::vector<glm::dvec3>& normals) {
  const glm::dvec3 normal = normals[point], size = glm::abs(normal);
  const glm::dvec3 least = size.x <= size.y && size.x <= size.z ? glm::dvec3(1.0, 0.0, 0.0)
                           : size.y <= size.z                   ? glm::dvec3(0.0, 1.0, 0.0)
                                                                : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 first = glm::normalize(glm::cross(normal, least)), second = glm::cross(normal, first);
  double xx = 0.0, xy = 0.0, yy = 0.0;
  glm::dvec3 right(0.0);
  for (const std::size_t other : neighboursOf(point, positions, normals)) {
    const glm::dvec3 away = positions[other] - positions[point], turn = normals[other] - normal;
    const glm::dvec2 u(glm::dot(away, first), glm::dot(away, second));
    const glm::dvec2 d(glm::dot(turn, first), glm::dot(turn, second));
    xx += u.x * u.x;
    xy += u.x * u.y;
    yy += u.y * u.y;
    right += glm::dvec3(u.x * d.x, u.y * d.x + u.x * d.y, u.y * d.y);
  }
  const glm::dmat3 system(xx, xy, 0.0, xy, xx + yy, xy, 0.0, xy, yy);
  const double scale = (xx + yy) * (xx + yy) * (xx + yy);
  constexpr double regular = 1e-9;  // below it, the neighbours lie on a line
  if (!(std::abs(glm::determinant(system)) > regular * scale)) return std::numeric_limits<double>::quiet_NaN();
  const glm::dvec3 s = glm::inverse(system) * right;
  return s.x * s.z - s.y * s.y;
}

}  // namespace

std::vector<double> gaussianCurvatures(const std::vector<glm::dvec3>& positions,
                                       const std::vector<glm::dvec3>& normals) {
  std::vector<double> curvatures(positions.size());
  parallelFor(positions.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t point = begin; point < end; ++point) curvatures[point] = curvatureAt(point, positions, normals);
  });
  return curvatures;
}

int curvatureClass(double curvature, double area) {
  return static_cast<int>(std::lround(std::asinh(curvature * area / (4.0 * std::numbers::pi)) / classWidth));
}

}  // namespace fenestra::placement
