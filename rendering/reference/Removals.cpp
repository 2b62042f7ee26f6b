#include "rendering/reference/Removals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "rendering/scene/RemovedVoxels.h"

namespace fenestra::reference {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// From p to the line from a to b, found between its ends and where its derivative is 0.
double lineDistance(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b) {
  double least = std::min(glm::distance(p, a), glm::distance(p, b));
  const glm::dvec3 way = b - a;
  if (const double t = glm::dot(p - a, way) / glm::dot(way, way); t > 0.0 && t < 1.0)
    least = std::min(least, glm::distance(p, a + t * way));
  return least;
}

double pathDistance(const std::vector<glm::dvec3>& path, glm::dvec3 p) {
  double least = glm::distance(p, path.front());
  for (std::size_t i = 1; i < path.size(); ++i) least = std::min(least, lineDistance(p, path[i - 1], path[i]));
  return least;
}

/// A vector without its part along a unit vector.
glm::dvec3 flattened(glm::dvec3 vector, glm::dvec3 unit) { return vector - glm::dot(vector, unit) * unit; }

double boxDistance(const Removal& box, glm::dvec3 p) {
  const glm::dvec3 forward = glm::normalize(box.direction), up = glm::normalize(flattened(box.up, forward));
  const std::array<glm::dvec3, 3> axes{glm::cross(forward, up), up, forward};
  double least = infinite;
  for (const glm::dvec3& centre : box.points) {
    // Outside, the distance to the nearest point of the box; inside, to the nearest face.
    glm::dvec3 nearest = centre;
    double inside = infinite;
    for (std::size_t i = 0; i < 3; ++i) {
      const double along = glm::dot(p - centre, axes[i]), half = 0.5 * box.sides[static_cast<int>(i)];
      nearest += std::clamp(along, -half, half) * axes[i];
      inside = std::min({inside, half - along, half + along});
    }
    least = std::min(least, inside > 0.0 ? -inside : glm::distance(p, nearest));
  }
  return least;
}

/// The share of a full turn by which a closed path turns around a line along `axis` through p.
double turns(const std::vector<glm::dvec3>& path, glm::dvec3 p, glm::dvec3 axis) {
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const glm::dvec3 a = flattened(path[i - 1] - p, axis), b = flattened(path[i] - p, axis);
    sum += std::atan2(glm::dot(axis, glm::cross(a, b)), glm::dot(a, b));
  }
  return sum / (2.0 * std::numbers::pi);
}

double sawDistance(const Removal& saw, glm::dvec3 p) {
  const glm::dvec3 forward = glm::normalize(saw.direction);
  std::vector<glm::dvec3> flat;
  double nearest = infinite;
  for (const glm::dvec3& point : saw.points) {
    flat.push_back(flattened(point, forward));
    nearest = std::min(nearest, glm::dot(point, forward));
  }
  double across = pathDistance(flat, flattened(p, forward));
  if (saw.points.size() > 3 && saw.points.front() == saw.points.back() &&
      std::lround(turns(saw.points, p, forward)) % 2 != 0)
    across = -across;
  across -= 0.5 * saw.size;
  return saw.depth > 0.0 ? std::max(across, glm::dot(p, forward) - nearest - saw.depth) : across;
}

double planeDistance(const Removal& removal, glm::dvec3 p) {
  const FittedPlane plane = planeThrough(removal.points, removal.direction);
  const StrokePlane axes(removal.points, removal.direction);  // which way the square lies
  const double above = glm::dot(p - plane.centre, plane.normal) - bentHeight(plane, removal.bends, p);
  // The surface's gradient by differences.
  constexpr double step = 1e-5;
  glm::dvec2 gradient;
  for (int i = 0; i < 2; ++i) {
    const glm::dvec3 aside = step * (i == 0 ? axes.first : axes.second);
    gradient[i] =
        (bentHeight(plane, removal.bends, p + aside) - bentHeight(plane, removal.bends, p - aside)) / (2.0 * step);
  }
  const double steepness = std::sqrt(1.0 + glm::dot(gradient, gradient));
  double distance = -above / steepness;
  if (removal.depth > 0.0) distance = std::max(distance, (above - removal.depth) / steepness);
  if (removal.extent > 0.0)
    for (const glm::dvec3& axis : {axes.first, axes.second})
      distance = std::max(distance, std::abs(glm::dot(p - plane.centre, axis)) - removal.extent);
  return distance;
}

double signedDistance(const Removal& removal, glm::dvec3 p) {
  switch (removal.shape) {
    case RemovalShape::Ball:
      return pathDistance(removal.points, p) - removal.size;
    case RemovalShape::Box:
      return boxDistance(removal, p);
    case RemovalShape::Saw:
      return sawDistance(removal, p);
    case RemovalShape::Plane:
      break;
  }
  return planeDistance(removal, p);
}

/// The parts of a removal whose coverages are found one by one: lines of a ball's path, or boxes.
std::vector<Removal> partsOf(const Removal& removal) {
  std::vector<Removal> parts;
  const std::vector<glm::dvec3>& points = removal.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    parts.push_back(removal);
    if (removal.shape == RemovalShape::Box) {
      parts.back().points = {points[i]};
    } else if (removal.shape == RemovalShape::Ball && points.size() > 1) {
      parts.back().points = {points[i], points[i + 1]};
      if (i + 2 == points.size()) return parts;
    } else {
      return parts;
    }
  }
  return parts;
}

double coverageOf(const Removal& part, const Grid& grid, glm::dvec3 world) {
  double squares = 0.0, diagonal = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 step = grid.spacing[axis] * grid.direction[axis];
    squares += std::pow(signedDistance(part, world + 0.5 * step) - signedDistance(part, world - 0.5 * step), 2.0);
    diagonal += std::pow(grid.spacing[axis], 2.0);
  }
  const double rim = std::max(part.softness, 2.0 * std::sqrt(std::min(squares, diagonal)));
  const double distance = signedDistance(part, world);
  if (rim > 0.0) return std::clamp(0.5 - distance / rim, 0.0, 1.0);
  return distance < 0.0 ? 1.0 : distance > 0.0 ? 0.0 : 0.5;
}

/// The unit vector along which points spread least: the power method on the trace less the covariance, whose greatest
/// eigenvalue is the covariance's least.
glm::dvec3 leastSpread(const glm::dmat3& covariance) {
  const double trace = covariance[0][0] + covariance[1][1] + covariance[2][2];
  glm::dmat3 power = glm::dmat3(trace) - covariance;
  for (int squarings = 0; squarings < 40; ++squarings) {
    power = power * power;
    double size = 0.0;
    for (int i = 0; i < 3; ++i) size = std::max(size, glm::length(power[i]));
    power /= size;
  }
  glm::dvec3 longest = power[0];
  for (int i = 1; i < 3; ++i)
    if (glm::length(power[i]) > glm::length(longest)) longest = power[i];
  return glm::normalize(longest);
}

}  // namespace

FittedPlane planeThrough(const std::vector<glm::dvec3>& points, glm::dvec3 towards) {
  FittedPlane plane;
  for (const glm::dvec3& point : points) plane.centre += point;
  plane.centre /= static_cast<double>(points.size());
  glm::dmat3 covariance(0.0);
  for (const glm::dvec3& point : points) {
    const glm::dvec3 d = point - plane.centre;
    covariance += glm::dmat3(d * d.x, d * d.y, d * d.z);
  }
  covariance /= static_cast<double>(points.size());
  const double spread = covariance[0][0] + covariance[1][1] + covariance[2][2];
  if (!(spread > 1e-12)) {
    plane.normal = glm::normalize(towards);
    return plane;
  }
  const glm::dvec3 normal = leastSpread(covariance);
  // The axis along which the points spread most is square to the normal, and so is the third.
  const double least = glm::dot(normal, covariance * normal);
  glm::dmat3 flat = covariance;
  for (int i = 0; i < 3; ++i) flat[i] = flattened(flat[i], normal);
  const double trace = spread - least;
  double determinant = 0.0;  // of the covariance within the plane, by the minors of the whole
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    determinant += flat[i][i] * flat[j][j] - flat[i][j] * flat[j][i];
  }
  const double root = std::sqrt(std::max(0.25 * trace * trace - determinant, 0.0));
  const double most = 0.5 * trace + root, second = 0.5 * trace - root;
  plane.normal = normal;
  if (!(second > most / 400.0)) {
    // Most of the spread is along the line, so that the covariance, applied again and again, turns any vector towards
    // it.
    glm::dvec3 line(covariance[0] + 0.5 * covariance[1] + 0.25 * covariance[2]);
    for (int i = 0; i < 3; ++i)
      if (glm::length(covariance[i]) > glm::length(line)) line = covariance[i];
    for (int times = 0; times < 60; ++times) line = glm::normalize(covariance * line);
    plane.normal = glm::normalize(flattened(towards, glm::normalize(line)));
  }
  if (glm::dot(plane.normal, towards) < 0.0) plane.normal = -plane.normal;
  return plane;
}

double bentHeight(const FittedPlane& plane, const std::vector<Bend>& bends, glm::dvec3 world) {
  const auto onPlane = [&](glm::dvec3 p) { return plane.centre + flattened(p - plane.centre, plane.normal); };
  if (bends.empty()) return 0.0;
  const std::vector<Bend> before(bends.begin(), bends.end() - 1);
  const Bend& last = bends.back();
  const double height = bentHeight(plane, before, world);
  const glm::dvec3 here = onPlane(world) + height * plane.normal;
  const glm::dvec3 dragged = onPlane(last.point) + bentHeight(plane, before, last.point) * plane.normal;
  const double share = glm::distance(here, dragged) / last.radius;
  return share < 1.0 ? height + last.distance * std::pow(1.0 - share * share, 2.0) : height;
}

double coverage(const Removals& removals, const Grid& grid, glm::dvec3 world) {
  double greatest = 0.0;
  for (const Removal& removal : removals) {
    if (!removesAnything(removal)) continue;
    for (const Removal& part : partsOf(removal)) greatest = std::max(greatest, coverageOf(part, grid, world));
  }
  return greatest;
}

}  // namespace fenestra::reference
