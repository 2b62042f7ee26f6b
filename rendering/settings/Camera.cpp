#include "rendering/settings/Camera.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace fenestra {
namespace {

/// The world axis least aligned with `direction`: a stand-in up that is never parallel to it.
glm::dvec3 leastAlignedAxis(glm::dvec3 direction) {
  const glm::dvec3 size = glm::abs(direction);
  if (size.z <= size.x && size.z <= size.y) return {0.0, 0.0, 1.0};
  return size.y <= size.x ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
}

Camera framed(glm::dvec3 towardsEye, glm::dvec3 up, const Framing& framing, Projection projection) {
  Camera camera;
  camera.projection = projection;
  camera.target = framing.centre;
  camera.up = up;
  // Fit the points as seen from here: the eye stands far enough for each to lie inside the vertical field of view.
  const double halfAngle = glm::radians(camera.verticalFov) * 0.5;
  camera.eye = camera.target + towardsEye;
  const Camera::Axes axes = camera.axes();
  double distance = 0.0, halfHeight = 0.0;
  for (const glm::dvec3& point : framing.points) {
    const glm::dvec3 offset = point - camera.target;
    const double lateral = std::max(std::abs(glm::dot(offset, axes.right)), std::abs(glm::dot(offset, axes.up)));
    halfHeight = std::max(halfHeight, lateral);
    distance = std::max(distance, lateral / std::tan(halfAngle) - glm::dot(offset, axes.forward));
  }
  constexpr double margin = 1.03;
  camera.orthographicHeight = 2.0 * halfHeight * margin;
  // Parallel rays start on the plane through the eye, which must lie before all of it.
  const double orthographicDistance = framing.radius() * 2.0;
  camera.eye =
      camera.target + towardsEye * (projection == Projection::Perspective ? distance * margin : orthographicDistance);
  return camera;
}

}  // namespace

glm::dvec3 uprightFrom(glm::dvec3 towardsEye) {
  constexpr double nearAxis = 0.9659258262890683;  // cos 15°
  return std::abs(towardsEye.z) > nearAxis ? glm::dvec3(0.0, -1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
}

Camera::Axes Camera::axes() const {
  glm::dvec3 forward = target - eye;
  const double length = glm::length(forward);
  forward = length > 0.0 ? forward / length : glm::dvec3(0.0, 1.0, 0.0);
  glm::dvec3 right = glm::cross(forward, up);
  // Below 1e-5 the cross product of the two is rounding noise.
  if (!(glm::length(right) > 1e-5 * glm::length(up))) right = glm::cross(forward, leastAlignedAxis(forward));
  right = glm::normalize(right);
  return {right, glm::cross(right, forward), forward};
}

glm::dmat4 Camera::viewFromWorld() const {
  const Axes a = axes();
  const glm::dmat3 rotation = glm::transpose(glm::dmat3(a.right, a.up, -a.forward));
  glm::dmat4 result(rotation);
  result[3] = glm::dvec4(-(rotation * eye), 1.0);
  return result;
}

glm::dmat4 Camera::clipFromView(double aspect, const Grid& grid) const {
  const double radius = std::max(grid.boundingRadius(), 1e-9);
  const double depth = glm::dot(grid.centre() - eye, axes().forward);
  const double farPlane = std::max(depth + radius, radius);
  if (projection == Projection::Orthographic) {
    const double halfHeight = orthographicHeight * 0.5, halfWidth = halfHeight * aspect;
    return glm::ortho(-halfWidth, halfWidth, -halfHeight, halfHeight, 0.0, farPlane);
  }
  const double nearPlane = std::max(depth - radius, radius * 1e-3);
  return glm::perspective(glm::radians(verticalFov), aspect, nearPlane, farPlane);
}

glm::dmat4 Camera::clipFromWorld(double aspect, const Grid& grid) const {
  return clipFromView(aspect, grid) * viewFromWorld();
}

Camera Camera::rotated(const glm::dmat3& worldRotation) const {
  Camera camera = *this;
  camera.eye = target + worldRotation * (eye - target);
  camera.up = worldRotation * up;
  return camera;
}

Camera Camera::orbited(double yaw, double pitch) const {
  const Axes a = axes();
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), yaw, a.up) * glm::rotate(glm::dmat4(1.0), pitch, a.right);
  Camera camera = *this;
  camera.up = a.up;
  return camera.rotated(glm::dmat3(turn));
}

Camera Camera::zoomed(double factor) const {
  Camera camera = *this;
  if (projection == Projection::Perspective) camera.eye = target + (eye - target) / factor;
  camera.orthographicHeight = orthographicHeight / factor;
  return camera;
}

Camera Camera::panned(double rightMm, double upMm) const {
  const Axes a = axes();
  const glm::dvec3 shift = a.right * rightMm + a.up * upMm;
  Camera camera = *this;
  camera.eye += shift;
  camera.target += shift;
  return camera;
}

std::optional<Camera> Camera::aimedAt(glm::dvec3 point) const {
  const Axes a = axes();
  const glm::dvec3 from = point - eye;
  if (!(glm::dot(from, a.forward) > 0.0)) return std::nullopt;
  if (projection == Projection::Orthographic) return panned(glm::dot(from, a.right), glm::dot(from, a.up));
  Camera aimed = *this;
  aimed.target = point;
  return aimed;
}

Camera Camera::widened(glm::ivec2 from, glm::ivec2 to) const {
  const Axes a = axes();
  const bool parallel = projection == Projection::Orthographic;
  const double distance = glm::distance(eye, target), tangent = std::tan(glm::radians(verticalFov) * 0.5);
  const double pixel = (parallel ? orthographicHeight : 2.0 * tangent * distance) / from.y;  // mm at the target
  const glm::dvec2 shift = 0.5 * pixel * glm::dvec2(to - from);
  Camera wider = *this;
  if (parallel) {
    wider = panned(shift.x, -shift.y);
    wider.orthographicHeight *= static_cast<double>(to.y) / from.y;
    return wider;
  }
  wider.target += shift.x * a.right - shift.y * a.up;
  wider.verticalFov = glm::degrees(2.0 * std::atan(tangent * to.y / from.y));
  return wider;
}

Camera Camera::beside() const {
  Camera camera = orbited(glm::half_pi<double>(), 0.0);
  camera.up = {0.0, 0.0, 1.0};
  return camera;
}

Camera Camera::fittedTo(double aspect) const {
  Camera camera = *this;
  if (aspect < 1.0) {
    camera.verticalFov = glm::degrees(2.0 * std::atan(std::tan(glm::radians(verticalFov) * 0.5) / aspect));
    camera.orthographicHeight /= aspect;
  }
  return camera;
}

Camera Camera::standard(StandardView view, const Framing& framing, Projection projection) {
  const glm::dvec3 superior(0.0, 0.0, 1.0), anterior(0.0, -1.0, 0.0);
  switch (view) {
    case StandardView::Anterior:
      return framed(anterior, superior, framing, projection);
    case StandardView::Posterior:
      return framed(-anterior, superior, framing, projection);
    case StandardView::Left:
      return framed({1.0, 0.0, 0.0}, superior, framing, projection);
    case StandardView::Right:
      return framed({-1.0, 0.0, 0.0}, superior, framing, projection);
    case StandardView::Superior:
      return framed(superior, anterior, framing, projection);
    case StandardView::Inferior:
      break;
  }
  return framed(-superior, anterior, framing, projection);
}

Camera Camera::fromDirection(glm::dvec3 towardsEye, const Framing& framing, Projection projection) {
  return framed(towardsEye, uprightFrom(towardsEye), framing, projection);
}

Camera Camera::fromAngles(double azimuth, double elevation, const Framing& framing, Projection projection) {
  const double az = glm::radians(azimuth), el = glm::radians(elevation);
  const glm::dvec3 towardsEye(std::sin(az) * std::cos(el), -std::cos(az) * std::cos(el), std::sin(el));
  // For a view along the body axis, "up" points away from the azimuth's side, where the head would tip to.
  const glm::dvec3 up = std::abs(std::cos(el)) > 1e-6
                            ? glm::dvec3(0.0, 0.0, 1.0)
                            : glm::dvec3(-std::sin(az), std::cos(az), 0.0) * (el > 0.0 ? 1.0 : -1.0);
  return framed(towardsEye, up, framing, projection);
}

}  // namespace fenestra
