#include "rendering/scene/Explosion.h"

#include <algorithm>
#include <cmath>

#include "rendering/settings/Look.h"

namespace fenestra {
namespace {

/// The share of the force that a step moves a part by: far less than the inverse of the slopes of the forces near rest,
/// so that steps do not overshoot. Tests find all layouts at rest before mostSteps.
constexpr double stride = 0.2;
constexpr int mostSteps = 20000;

/// Samples along each side of the volume by which the middles of the parts are found.
constexpr int samples = 16;

/// How strong the forces are; see the header.
constexpr double explosionStrength = 2.0 / 3.0, viewingStrength = 1.0 / 3.0, spacingStrength = 1.0 / 15.0;

/// Shorter vectors have no direction; in units of R.
constexpr double shortest = 1e-9;

glm::dmat3 axesOf(ExplosionAxes axes, const Camera& camera) {
  if (axes == ExplosionAxes::Patient)  // L, S and P
    return {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 1.0, 0.0)};
  const Camera::Axes view = camera.axes();
  return {view.right, view.up, view.forward};
}

}  // namespace

std::optional<MethodStages::Explosion> explosionOf(const Look& look) {
  return look.cutaway.enabled ? stagesOf(look.method).explosion : std::nullopt;
}

ExplodedView::ExplodedView(const MethodStages::Explosion& explosion, const Grid& grid, glm::dvec3 middle,
                           const Camera& camera)
    : explosion_(explosion),
      middle_(middle),
      radius_(grid.boundingRadius()),
      axes_(axesOf(explosion.axes, camera)),
      places_(std::size_t{1} << explosion.planes, glm::dvec3(0.0)),
      moved_(places_.size(), glm::dvec3(0.0)) {
  const Camera::Axes view = camera.axes();
  const glm::dvec3 fromEye = middle - camera.eye;
  const bool isSeen = camera.projection == Projection::Perspective && glm::length(fromEye) > shortest * radius_;
  sight_ = glm::transpose(axes_) * (isSeen ? glm::normalize(fromEye) : view.forward);
  right_ = glm::transpose(axes_) * view.right;
  for (int k = 0; k < explosion.planes; ++k)
    if (sight_[k] < 0.0) nearest_ |= std::size_t{1} << k;
  place(grid);
  for (int step = 0; step < mostSteps; ++step) {
    double greatest = 0.0;
    std::vector<glm::dvec3> next = moved_;
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      const glm::dvec3 force = forceOn(i);
      for (int axis = 0; axis < 3; ++axis) {
        if (!isFree(i, axis, force[axis])) continue;
        greatest = std::max(greatest, std::abs(force[axis]));
        next[i][axis] += stride * force[axis];
        if (axis < explosion.planes && side(i, axis) * next[i][axis] < 0.0) next[i][axis] = 0.0;
      }
    }
    if (greatest <= atRest) break;
    moved_ = std::move(next);
  }
}

/// The mean of the samples in each part. A part without any is a sliver beside a plane.
void ExplodedView::place(const Grid& grid) {
  std::vector<int> counts(places_.size(), 0);
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  for (int s = 0; s < samples * samples * samples; ++s) {
    const glm::ivec3 at(s % samples, s / samples % samples, s / samples / samples);
    const glm::dvec3 index = (glm::dvec3(at) + 0.5) / double{samples} * glm::dvec3(grid.dims) - 0.5;
    const glm::dvec3 place =
        glm::transpose(axes_) * (glm::dvec3(worldFromIndex * glm::dvec4(index, 1.0)) - middle_) / radius_;
    std::size_t part = 0;
    for (int k = 0; k < explosion_.planes; ++k) part |= static_cast<std::size_t>(place[k] > 0.0) << k;
    places_[part] += place;
    ++counts[part];
  }
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (counts[i] > 0) {
      places_[i] /= counts[i];
      continue;
    }
    for (int k = 0; k < explosion_.planes; ++k) places_[i][k] = side(i, k) / samples;
  }
}

bool ExplodedView::isFree(std::size_t part, int axis, double force) const {
  return axis >= explosion_.planes || moved_[part][axis] != 0.0 || side(part, axis) * force > 0.0;
}

glm::dvec3 ExplodedView::forceOn(std::size_t i) const {
  const glm::dvec3 p = places_[i] + moved_[i];
  const double away = std::max(glm::length(p), shortest), before = -glm::dot(p, sight_) / away;
  glm::dvec3 pushed = explosionStrength * std::exp(-away) * p / away;
  const glm::dvec3 aside = p - glm::dot(p, sight_) * sight_;
  const double offset = glm::length(aside);
  if (before > 0.0)
    pushed += viewingStrength * before * std::exp(-offset) * (offset > shortest ? aside / offset : right_);
  for (std::size_t j = 0; j < places_.size(); ++j) {
    if (j == i) continue;
    const glm::dvec3 apart = p - places_[j] - moved_[j];
    const double distance = std::max(glm::length(apart), shortest);
    pushed += spacingStrength / static_cast<double>(places_.size() - 1) / (distance * distance * distance) * apart;
  }
  return explosion_.degree * pushed - moved_[i];
}

std::vector<ExplodedPart> ExplodedView::parts() const {
  std::vector<ExplodedPart> result;
  for (std::size_t turn = 0; turn < places_.size(); ++turn) {
    const std::size_t i = turn ^ nearest_;
    ExplodedPart part{{}, axes_ * translation(i)};
    for (int k = 0; k < explosion_.planes; ++k) {
      const glm::dvec3 normal = side(i, k) * axes_[k];
      part.kept.push_back({normal, glm::dot(normal, middle_)});
    }
    result.push_back(std::move(part));
  }
  return result;
}

}  // namespace fenestra
