#include <algorithm>
#include <cmath>
#include <limits>

#include "rendering/reference/Reference.h"

namespace fenestra::reference {

Ray pixelRay(const Camera& camera, glm::ivec2 size, glm::ivec2 pixel) {
  const Camera::Axes axes = camera.axes();
  const double aspect = static_cast<double>(size.x) / size.y;
  const double x = (2.0 * (pixel.x + 0.5) / size.x - 1.0) * aspect, y = 1.0 - 2.0 * (pixel.y + 0.5) / size.y;
  if (camera.projection == Projection::Orthographic) {
    const double halfHeight = 0.5 * camera.orthographicHeight;
    return {camera.eye + (x * axes.right + y * axes.up) * halfHeight, axes.forward};
  }
  const double slope = std::tan(0.5 * glm::radians(camera.verticalFov));
  return {camera.eye, glm::normalize(axes.forward + (x * axes.right + y * axes.up) * slope)};
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

Ray indexRay(const Ray& ray, const Grid& grid) {
  const glm::dmat3 worldFromIndex(grid.worldFromIndex());
  const glm::dmat3 indexFromWorld = glm::inverse(worldFromIndex);
  // The origins are subtracted first: both may be metres away from the volume's own few hundred millimetres.
  return {indexFromWorld * (ray.origin - grid.origin), indexFromWorld * ray.direction};
}

}  // namespace fenestra::reference
