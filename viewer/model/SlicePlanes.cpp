#include "viewer/model/SlicePlanes.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "viewer/model/Document.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/ViewLink.h"

namespace fenestra::viewer {
namespace {

/// ms without a change after which a camera is at rest.
constexpr int restMilliseconds = 200;

}  // namespace

PlaneAxes axesFacing(const Camera& camera) {
  const Camera::Axes axes = camera.axes();
  return {axes.right, -axes.up, axes.forward};
}

PlaneAxes turned(const PlaneAxes& axes, glm::dvec3 about, double radians) {
  const glm::dmat3 rotation(glm::rotate(glm::dmat4(1.0), radians, about));
  PlaneAxes result;
  // Made perpendicular anew, so that many turns do not add up their rounding.
  result.right = glm::normalize(rotation * axes.right);
  const glm::dvec3 down = rotation * axes.down;
  result.down = glm::normalize(down - glm::dot(down, result.right) * result.right);
  const glm::dvec3 normal = glm::cross(result.right, result.down);
  result.normal = glm::dot(glm::cross(axes.right, axes.down), axes.normal) < 0.0 ? -normal : normal;
  return result;
}

SlicePlanes::SlicePlanes(const Document& document, const SliceCursor& cursor, const ViewLink& cameras)
    : document_(document), cursor_(cursor), cameras_(cameras) {
  rest_.setSingleShot(true);
  rest_.setInterval(restMilliseconds);
  connect(&document, &Document::volumeChanged, this, [this] {
    poses_ = {};
    dragged_ = false;
    rest_.stop();
  });
  connect(&cameras, &ViewLink::changed, this, &SlicePlanes::followCamera);
  connect(&rest_, &QTimer::timeout, this, [this] {
    for (const SlicePlane plane : all)
      if (pose(plane).follow != PlaneFollow::None) Q_EMIT changed(plane);
  });
}

void SlicePlanes::setPoses(const std::array<PlanePose, 3>& poses) {
  for (const SlicePlane plane : all) {
    change(plane, poses[index(plane)]);
    if (const PlaneFollow follow = pose(plane).follow; follow != PlaneFollow::None) setFollow(plane, follow);
  }
}

PlaneAxes SlicePlanes::axes(SlicePlane plane) const {
  return pose(plane).axes.value_or(planeAxes(document_.scene().volume->grid, plane));
}

SliceGeometry SlicePlanes::geometry(SlicePlane plane) const {
  const Grid& grid = document_.scene().volume->grid;
  const std::optional<PlaneAxes>& axes = pose(plane).axes;
  if (!axes) return sliceGeometry(grid, plane);
  const glm::dvec3 centre = grid.centre();
  return obliqueGeometry(grid, plane, *axes,
                         centre + glm::dot(cursor_.position() - centre, axes->normal) * axes->normal);
}

PlaneTilt SlicePlanes::tilt(SlicePlane plane) const {
  const glm::dvec3 normal = glm::abs(axes(plane).normal);
  PlaneTilt tilt;
  const double most = std::max({normal.x, normal.y, normal.z});
  tilt.from = most == normal.z ? SlicePlane::Axial : most == normal.x ? SlicePlane::Sagittal : SlicePlane::Coronal;
  // An arc cosine would lose half of the digits near 0.
  tilt.degrees = glm::degrees(std::atan2(std::sqrt(std::max(0.0, glm::dot(normal, normal) - most * most)), most));
  return tilt;
}

void SlicePlanes::change(SlicePlane plane, const PlanePose& pose) {
  if (poses_[index(plane)] == pose) return;
  poses_[index(plane)] = pose;
  Q_EMIT changed(plane);
}

void SlicePlanes::setAxes(SlicePlane plane, const PlaneAxes& axes) {
  PlanePose to = pose(plane);
  to.axes = axes;
  to.follow = PlaneFollow::None;
  change(plane, to);
}

void SlicePlanes::setFollow(SlicePlane plane, PlaneFollow follow) {
  PlanePose to = pose(plane);
  to.follow = follow;
  if (follow != PlaneFollow::None) to.axes = axesFacing(cameras_.camera(follow == PlaneFollow::C1 ? 0 : 1));
  change(plane, to);
}

void SlicePlanes::reset(SlicePlane plane) {
  PlanePose to;
  to.slab = pose(plane).slab;
  change(plane, to);
}

void SlicePlanes::resetAll() {
  for (const SlicePlane plane : all) reset(plane);
}

void SlicePlanes::setSlab(SlicePlane plane, Slab slab) {
  slab.thickness = std::clamp(slab.thickness, 0.0, io::mostSlab);
  PlanePose to = pose(plane);
  to.slab = slab;
  change(plane, to);
}

void SlicePlanes::stepSlab(SlicePlane plane, int steps) {
  Slab slab = pose(plane).slab;
  for (; steps > 0; --steps) {
    const auto next = std::upper_bound(thicknesses.begin(), thicknesses.end(), slab.thickness);
    if (next != thicknesses.end()) slab.thickness = *next;
  }
  for (; steps < 0; ++steps) {
    const auto next = std::lower_bound(thicknesses.begin(), thicknesses.end(), slab.thickness);
    if (next != thicknesses.begin()) slab.thickness = *std::prev(next);
  }
  setSlab(plane, slab);
}

bool SlicePlanes::isMoving(SlicePlane plane) const {
  return isTurned(plane) && (dragged_ || (rest_.isActive() && pose(plane).follow != PlaneFollow::None));
}

void SlicePlanes::setDragged(bool dragged) {
  if (dragged_ == dragged) return;
  dragged_ = dragged;
  for (const SlicePlane plane : all)
    if (isTurned(plane)) Q_EMIT changed(plane);
}

void SlicePlanes::followCamera(int camera) {
  const PlaneFollow follow = camera == 0 ? PlaneFollow::C1 : PlaneFollow::C2;
  for (const SlicePlane plane : all) {
    if (pose(plane).follow != follow) continue;
    rest_.start();
    setFollow(plane, follow);
  }
}

}  // namespace fenestra::viewer
