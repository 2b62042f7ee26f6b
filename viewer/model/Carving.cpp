#include "viewer/model/Carving.h"

#include <algorithm>
#include <cmath>

#include "rendering/scene/RemovedVoxels.h"
#include "viewer/model/Document.h"

namespace fenestra::viewer {
namespace {

/// The path with more points, no farther apart than `most` mm.
std::vector<glm::dvec3> withoutGaps(const std::vector<glm::dvec3>& path, double most) {
  std::vector<glm::dvec3> closer;
  for (const glm::dvec3& point : path) {
    if (!closer.empty()) {
      const glm::dvec3 from = closer.back();
      const int steps = static_cast<int>(std::min(std::ceil(glm::distance(from, point) / most), 1000.0));
      for (int i = 1; i < steps; ++i) closer.push_back(glm::mix(from, point, static_cast<double>(i) / steps));
    }
    closer.push_back(point);
  }
  return closer;
}

}  // namespace

Removal carvedAlong(const std::vector<glm::dvec3>& stroke, const CarvingSettings& settings, const Camera::Axes& axes) {
  Removal removal;
  removal.shape = settings.shape;
  removal.points = stroke;
  removal.size = settings.size;
  removal.sides = glm::dvec3(2.0 * settings.size);
  removal.direction = axes.forward;
  removal.up = axes.up;
  removal.softness = settings.softness;
  const bool reaches = settings.shape == RemovalShape::Saw || settings.shape == RemovalShape::Plane;
  if (reaches) removal.depth = settings.depth;
  if (settings.shape == RemovalShape::Box) removal.points = withoutGaps(stroke, 0.5 * settings.size);
  if (settings.shape == RemovalShape::Saw && stroke.size() > 3 &&
      glm::distance(stroke.front(), stroke.back()) < settings.size)
    removal.points.push_back(stroke.front());
  if (settings.shape == RemovalShape::Plane && !stroke.empty()) {
    const glm::dvec3 aside = glm::cross(axes.forward, stroke.back() - stroke.front());
    removal.direction = glm::length(aside) > 1e-9 ? glm::normalize(aside) : axes.right;
  }
  return removal;
}

double bentBy(const Removal& plane, glm::dvec2 moved, const Camera::Axes& axes) {
  // Share of the normal's length that the view must show: with less, small moves would bend the plane far.
  constexpr double leastSeen = 0.3;
  const glm::dvec3 normal = StrokePlane(plane.points, plane.direction).normal;
  const glm::dvec2 seen(glm::dot(normal, axes.right), glm::dot(normal, axes.up));
  const double length2 = glm::dot(seen, seen);
  if (length2 < leastSeen * leastSeen) return glm::dot(normal, axes.forward) < 0.0 ? moved.y : -moved.y;
  return glm::dot(moved, seen) / length2;
}

Carving::Carving(Document& document, QObject* parent) : StrokeMode(parent), document_(document) {
  connect(&document, &Document::cutawayChanged, this, [this] {
    if (!isOffered()) setActive(false);
  });
}

bool Carving::isOffered() const {
  const Look& look = document_.look();
  return document_.hasVolume() && look.cutaway.enabled && carves(look.method.kind);
}

void Carving::setSettings(const CarvingSettings& settings) {
  CarvingSettings within = settings;
  forEachSetting<CarvingSettings>([&](const auto& setting) {
    double& value = within.*setting.member;
    value = std::clamp(value, setting.range.low, setting.range.high);
  });
  if (within == settings_) return;
  settings_ = within;
  Q_EMIT changed();
}

}  // namespace fenestra::viewer
