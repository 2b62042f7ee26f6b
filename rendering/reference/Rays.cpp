#include <algorithm>
#include <cmath>
#include <limits>

#include "rendering/reference/Reference.h"

namespace fenestra::reference {
namespace {

/// Cosine below which a ray runs along a plane: rounding decides where they meet.
constexpr double parallel = 1e-7;

}  // namespace

Ray rayThrough(const Camera& camera, glm::ivec2 size, glm::dvec2 place) {
  const Camera::Axes axes = camera.axes();
  const double aspect = static_cast<double>(size.x) / size.y;
  const double x = (2.0 * place.x / size.x - 1.0) * aspect, y = 1.0 - 2.0 * place.y / size.y;
  if (camera.projection == Projection::Orthographic) {
    const double halfHeight = 0.5 * camera.orthographicHeight;
    return {camera.eye + (x * axes.right + y * axes.up) * halfHeight, axes.forward};
  }
  const double slope = std::tan(0.5 * glm::radians(camera.verticalFov));
  return {camera.eye, glm::normalize(axes.forward + (x * axes.right + y * axes.up) * slope)};
}

Ray pixelRay(const Camera& camera, glm::ivec2 size, glm::ivec2 pixel) {
  return rayThrough(camera, size, glm::dvec2(pixel) + 0.5);
}

std::vector<glm::dvec2> centresOf(glm::ivec2 size) {
  std::vector<glm::dvec2> centres;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) centres.emplace_back(i + 0.5, j + 0.5);
  return centres;
}

std::optional<Span> clip(const Ray& ray, const Grid& grid) {
  const Ray local = indexRay(ray, grid);
  Span span{0.0, std::numeric_limits<double>::infinity()};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = -0.5, high = grid.dims[axis] - 0.5;
    const double origin = local.origin[axis], direction = local.direction[axis];
    if (direction == 0.0) {
      if (origin < low || origin > high) return {};
      continue;
    }
    const double a = (low - origin) / direction, b = (high - origin) / direction;
    span.tIn = std::max(span.tIn, std::min(a, b));
    span.tOut = std::min(span.tOut, std::max(a, b));
  }
  if (!(span.tIn <= span.tOut)) return {};
  return span;
}

namespace {

/// A half-space's part of a ray, on which it lets the ray enter or leave.
struct Crossing {
  double t = 0.0;
  bool enters = false;
};
/// Empty where the ray is parallel to the plane.
std::optional<Crossing> crossing(const Ray& ray, const HalfSpace& half) {
  const double slope = glm::dot(ray.direction, half.normal);
  if (std::abs(slope) < parallel) return {};
  return Crossing{-half.distance(ray.origin) / slope, slope > 0.0};
}

}  // namespace

std::optional<Span> clip(const Ray& ray, const Grid& grid, const std::vector<HalfSpace>& kept) {
  std::optional<Span> span = clip(ray, grid);
  if (!span) return {};
  for (const HalfSpace& half : kept) {
    if (const auto cross = crossing(ray, half)) {
      if (cross->enters)
        span->tIn = std::max(span->tIn, cross->t);
      else
        span->tOut = std::min(span->tOut, cross->t);
    } else if (half.distance(ray.origin) < 0.0) {
      return {};
    }
  }
  if (!(span->tIn <= span->tOut)) return {};
  return span;
}

std::optional<glm::dvec3> capNormal(const Ray& ray, const Grid& grid, const std::vector<HalfSpace>& kept) {
  const std::optional<Span> box = clip(ray, grid);
  if (!box || !clip(ray, grid, kept)) return {};
  double last = box->tIn;
  std::optional<glm::dvec3> normal;
  for (const HalfSpace& half : kept)
    if (const auto cross = crossing(ray, half); cross && cross->enters && cross->t > last) {
      last = cross->t;
      normal = half.normal;
    }
  return normal;
}

Ray indexRay(const Ray& ray, const Grid& grid) {
  const glm::dmat3 worldFromIndex(grid.worldFromIndex());
  const glm::dmat3 indexFromWorld = glm::inverse(worldFromIndex);
  // The origins are subtracted first: both may be metres away from the volume's own few hundred millimetres.
  return {indexFromWorld * (ray.origin - grid.origin), indexFromWorld * ray.direction};
}

}  // namespace fenestra::reference
