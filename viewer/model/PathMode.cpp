#include "viewer/model/PathMode.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "io/session/Session.h"
#include "viewer/model/ActiveTool.h"
#include "viewer/model/Document.h"
#include "viewer/model/MeasureMode.h"
#include "viewer/model/SliceCursor.h"

namespace fenestra::viewer {
namespace {

constexpr double samePoint = 1e-3;  ///< mm; as near as that, two points of a path are one

}  // namespace

std::vector<glm::dvec3> lineOf(const reformat::PathCurve& curve, double step) {
  std::vector<glm::dvec3> line;
  if (!(curve.length() > 0.0)) return line;
  constexpr double most = 20'000.0;  // points: a path of 20 m at a millimetre
  const int steps = static_cast<int>(std::clamp(std::ceil(curve.length() / step), 1.0, most));
  line.reserve(static_cast<std::size_t>(steps) + 1);
  for (int i = 0; i <= steps; ++i) line.push_back(curve.place(curve.length() * i / steps).point);
  return line;
}

double nearestPlace(const reformat::PathCurve& curve, const std::vector<glm::dvec3>& line, glm::dvec3 point) {
  double least = INFINITY, at = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const glm::dvec3 along = line[i] - line[i - 1], from = point - line[i - 1];
    const double square = glm::dot(along, along);
    const double share = square > 0.0 ? std::clamp(glm::dot(from, along) / square, 0.0, 1.0) : 0.0;
    const double distance = glm::distance(point, line[i - 1] + share * along);
    if (distance >= least) continue;
    least = distance;
    at = (static_cast<double>(i - 1) + share) / static_cast<double>(line.size() - 1);
  }
  return at * curve.length();
}

PathMode::PathMode(Document& document, SliceCursor& cursor, MeasureMode& measures, ActiveTool& tool)
    : document_(document), cursor_(cursor), measures_(measures), tool_(tool) {
  connect(&document, &Document::volumeChanged, this, &PathMode::stop);
  connect(&document, &Document::pathChanged, this, &PathMode::readPath);
  connect(&cursor, &SliceCursor::moved, this, &PathMode::followCursor);
  connect(&measures, &MeasureMode::changed, this, [this] {
    if (measures_.kind()) stop();
  });
  connect(&tool, &ActiveTool::changed, this, [this] {
    if (tool_.mode()) stop();
  });
}

void PathMode::toggle() {
  if (stop() || !document_.hasVolume()) return;
  tool_.putDown();
  while (measures_.stop()) {
  }
  drawing_ = true;
  Q_EMIT changed();
}

void PathMode::hover(std::optional<glm::dvec3> world) {
  if (!drawing_ || hovered_ == world) return;
  hovered_ = world;
  Q_EMIT changed();
}

void PathMode::addPoint(glm::dvec3 world) {
  if (!drawing_ || draft_.size() >= io::mostPathPoints) return;
  if (!draft_.empty() && glm::distance(draft_.back(), world) < samePoint) return;
  draft_.push_back(world);
  Q_EMIT changed();
}

bool PathMode::removeLast() {
  if (draft_.empty()) return false;
  draft_.pop_back();
  Q_EMIT changed();
  return true;
}

bool PathMode::finish() {
  if (!drawing_ || draft_.size() < 2) return false;
  std::vector<glm::dvec3> path = std::move(draft_);
  stop();
  document_.setPath(std::move(path), tr("Draw a path"));
  return true;
}

bool PathMode::stop() {
  if (!drawing_) return false;
  drawing_ = false;
  draft_.clear();
  hovered_.reset();
  Q_EMIT changed();
  return true;
}

void PathMode::movePoint(const std::vector<glm::dvec3>& before, std::size_t point, glm::dvec3 by) {
  std::vector<glm::dvec3> path = before;
  path.at(point) += by;
  // To each side as far as the reach goes, by a smooth share of the way: 1 at the point, 0 at the reach.
  const auto follow = [&](auto next, std::size_t last) {
    double away = 0.0;
    for (std::size_t i = point; i != last; i = next(i)) {
      away += glm::distance(before[i], before[next(i)]);
      if (away >= reach) return;
      const double share = std::cos(0.5 * std::numbers::pi * away / reach);
      path[next(i)] += share * share * by;
    }
  };
  follow([](std::size_t i) { return i + 1; }, before.size() - 1);
  follow([](std::size_t i) { return i - 1; }, 0);
  document_.setPath(std::move(path), tr("Move a point of the path"));
}

void PathMode::readPath() {
  curve_ = reformat::PathCurve(document_.path());
  line_ = lineOf(curve_, 1.0);
  place_ = nearestPlace(curve_, line_, cursor_.position());
  Q_EMIT changed();
}

void PathMode::setPlace(double mm) {
  if (!hasPath()) return;
  place_ = std::clamp(mm, 0.0, curve_.length());
  placing_ = true;  // where the path leaves the volume, or passes itself, the nearest place may be another
  cursor_.moveTo(curve_.place(place_).point);
  placing_ = false;
  Q_EMIT moved();
  Q_EMIT walked();
}

void PathMode::followCursor() {
  if (placing_ || !hasPath()) return;
  place_ = nearestPlace(curve_, line_, cursor_.position());
  Q_EMIT moved();
}

}  // namespace fenestra::viewer
