#include "viewer/model/ViewLink.h"

#include <cmath>

#include <glm/gtc/quaternion.hpp>

namespace fenestra::viewer {
namespace {

constexpr int flightMilliseconds = 300;

/// Columns right, up, backward of a camera, in world space.
glm::dmat3 worldFromView(const Camera& camera) {
  const Camera::Axes axes = camera.axes();
  return {axes.right, axes.up, -axes.forward};
}

/// `camera` with another projection, and objects at its target of the same size on screen. A parallel camera gets the
/// distance of `placed`: its rays start at the plane through the eye, which must stay in front of the volume.
Camera projected(Camera camera, Projection projection, const Camera& placed) {
  if (camera.projection == projection) return camera;
  const double slope = std::tan(glm::radians(camera.verticalFov) * 0.5);
  const glm::dvec3 forward = camera.axes().forward;
  double distance = camera.orthographicHeight * 0.5 / slope;
  if (projection == Projection::Orthographic) {
    camera.orthographicHeight = 2.0 * slope * glm::distance(camera.eye, camera.target);
    distance = glm::distance(placed.eye, placed.target);
  }
  camera.eye = camera.target - forward * distance;
  camera.projection = projection;
  return camera;
}

/// mm from the bottom to the top of the picture, at the target.
double heightAtTarget(const Camera& camera) {
  if (camera.projection == Projection::Orthographic) return camera.orthographicHeight;
  return 2.0 * std::tan(glm::radians(camera.verticalFov) * 0.5) * glm::distance(camera.eye, camera.target);
}

/// `camera`, with its target and its projection, in the direction and at the scale of another one.
Camera likened(Camera camera, const Camera& like) {
  const Camera::Axes axes = like.axes();
  double distance = glm::distance(camera.eye, camera.target);
  if (camera.projection == Projection::Orthographic)
    camera.orthographicHeight = heightAtTarget(like);
  else
    distance = heightAtTarget(like) * 0.5 / std::tan(glm::radians(camera.verticalFov) * 0.5);
  camera.eye = camera.target - axes.forward * distance;
  camera.up = axes.up;
  return camera;
}

}  // namespace

Camera between(const Camera& from, const Camera& to, double part) {
  if (part >= 1.0) return to;
  const glm::dmat3 turned =
      glm::mat3_cast(glm::slerp(glm::quat_cast(worldFromView(from)), glm::quat_cast(worldFromView(to)), part));
  Camera camera = to;
  camera.target = glm::mix(from.target, to.target, part);
  camera.eye = camera.target +
               turned[2] * glm::mix(glm::distance(from.eye, from.target), glm::distance(to.eye, to.target), part);
  camera.up = turned[1];
  camera.orthographicHeight = glm::mix(from.orthographicHeight, to.orthographicHeight, part);
  return camera;
}

Camera facing(Camera camera, glm::dvec3 towardsEye) {
  camera.eye = camera.target + towardsEye * glm::distance(camera.eye, camera.target);
  camera.up = uprightFrom(towardsEye);
  return camera;
}

glm::dvec3 directionOf(const Camera& camera) { return -camera.axes().forward; }

ViewLink::ViewLink(QObject* parent) : QObject(parent) {
  flight_.setDuration(flightMilliseconds);
  flight_.setEasingCurve(QEasingCurve::InOutQuad);
  flight_.setStartValue(0.0);
  flight_.setEndValue(1.0);
  connect(&flight_, &QVariantAnimation::valueChanged, this, [this](const QVariant& part) {
    for (int view = 0; view < count; ++view) {
      const auto at = static_cast<std::size_t>(view);
      set(view, between(from_[at], to_[at], part.toDouble()));
    }
  });
  connect(&flight_, &QVariantAnimation::finished, this, &ViewLink::landed);
}

void ViewLink::flyTo(const Pair& cameras, const Pair& home) {
  placed_ = home;
  if (isFlying() && cameras == to_) return;
  flight_.stop();
  from_ = cameras_;
  to_ = cameras;
  if (from_ == to_) return;
  flight_.start();
  if (!animated_) finishFlight();
}

void ViewLink::finishFlight() {
  if (isFlying()) flight_.setCurrentTime(flightMilliseconds);
}

void ViewLink::setAnimated(bool animated) {
  animated_ = animated;
  if (!animated) finishFlight();
}

void ViewLink::setLinked(bool linked) {
  if (linked == linked_) return;
  linked_ = linked;
  Q_EMIT linkedChanged(linked);
}

void ViewLink::place(const Pair& cameras) {
  placed_ = cameras;
  reset();
}

void ViewLink::setFrozen(const Frozen& frozen) {
  if (frozen == frozen_) return;
  frozen_ = frozen;
  Q_EMIT frozenChanged();
  for (int view = 0; view < count; ++view) Q_EMIT changed(view);
}

void ViewLink::reset() {
  flight_.stop();
  for (int view = 0; view < count; ++view) set(view, placed_[static_cast<std::size_t>(view)]);
}

void ViewLink::setPose(const Pose& pose) {
  placed_ = pose.cameras;
  reset();
  placed_ = pose.home;
  Q_EMIT projectionChanged(projection());
}

void ViewLink::rotate(int view, const glm::dmat3& worldRotation) {
  flight_.stop();
  for (int other = 0; other < count; ++other)
    if (other == view || linked_) set(other, camera(other).rotated(worldRotation));
  Q_EMIT turned(view);
}

void ViewLink::orbit(int view, double yaw, double pitch) {
  const Camera& from = camera(view);
  rotate(view, worldFromView(from.orbited(yaw, pitch)) * glm::transpose(worldFromView(from)));
}

void ViewLink::face(int view, StandardView side) {
  // Only the direction of the standard camera is used, so any grid will do.
  const Camera wanted = Camera::standard(side, Grid{.dims = glm::ivec3(1)});
  rotate(view, worldFromView(wanted) * glm::transpose(worldFromView(camera(view))));
}

void ViewLink::zoom(int view, double factor) {
  flight_.stop();
  for (int other = 0; other < count; ++other)
    if (other == view || linked_) set(other, camera(other).zoomed(factor));
}

void ViewLink::pan(int view, double rightMm, double upMm) {
  flight_.stop();
  set(view, camera(view).panned(rightMm, upMm));
}

void ViewLink::lookAs(int view, const Camera& like) {
  flight_.stop();
  set(view, likened(camera(view), like));
}

void ViewLink::setProjection(Projection projection) {
  if (isFlying()) {
    flight_.stop();
    cameras_ = to_;
  }
  for (Camera& camera : placed_) camera = projected(camera, projection, camera);
  for (int view = 0; view < count; ++view)
    set(view, projected(camera(view), projection, placed_[static_cast<std::size_t>(view)]));
}

void ViewLink::set(int view, const Camera& camera) {
  Camera& current = cameras_[static_cast<std::size_t>(view)];
  if (camera == current) return;
  current = camera;
  Q_EMIT changed(view);
}

}  // namespace fenestra::viewer
