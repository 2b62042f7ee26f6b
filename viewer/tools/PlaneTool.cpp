#include "viewer/tools/PlaneTool.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <QCoreApplication>
#include <QLineF>
#include <QMouseEvent>

#include <glm/gtc/constants.hpp>

#include "viewer/model/Workspace.h"
#include "viewer/style/Overlay.h"
#include "viewer/tools/Canvas.h"
#include "viewer/tools/HandleDrag.h"

namespace fenestra::viewer {
namespace {

/// Sine of the angle between two planes below which they count as parallel: their line would jump with rounding.
constexpr double leastPlaneSine = 0.02;
/// Device-independent pixels: of a handle from the view's edge, so that it does not cover the letter there, and from
/// the crosshair at least.
constexpr double handleFromEdge = 40.0, handleFromCross = 24.0;

struct PlaneToolWords {
  Q_DECLARE_TR_FUNCTIONS(PlaneTool)
};

double angleOf(QPointF direction) { return std::atan2(direction.y(), direction.x()); }

/// How far a ray from a point inside a box goes until it leaves it.
double wayOut(const QRectF& box, QPointF from, QPointF along) {
  double way = std::numeric_limits<double>::infinity();
  if (along.x() != 0.0) way = std::min(way, ((along.x() > 0.0 ? box.right() : box.left()) - from.x()) / along.x());
  if (along.y() != 0.0) way = std::min(way, ((along.y() > 0.0 ? box.bottom() : box.top()) - from.y()) / along.y());
  return way;
}

/// An angle between lines: -90° to 90°, in radians.
double betweenLines(double angle) { return std::remainder(angle, glm::pi<double>()); }

}  // namespace

PlaneTool::PlaneTool(Workspace& workspace, const SliceCanvas& canvas) : workspace_(workspace), canvas_(canvas) {}

std::optional<QPointF> PlaneTool::directionOf(const PlaneAxes& axes) const {
  const Canvas::Section section = *canvas_.section();
  const glm::dvec3 line = glm::cross(section.normal, axes.normal);
  if (glm::length(line) < leastPlaneSine) return std::nullopt;
  QPointF along = canvas_.onSlice(section.point + glm::normalize(line)) - canvas_.onSlice(section.point);
  along /= std::hypot(along.x(), along.y());
  // Rounding would put a pixel's step into a line along the picture's rows or columns.
  constexpr double rounding = 1e-7;
  if (std::abs(along.x()) < rounding) return QPointF(0.0, along.y() > 0.0 ? 1.0 : -1.0);
  if (std::abs(along.y()) < rounding) return QPointF(along.x() > 0.0 ? 1.0 : -1.0, 0.0);
  return along;
}

std::vector<PlaneCut> PlaneTool::cuts() const {
  std::vector<PlaneCut> cuts;
  const Canvas::Section section = *canvas_.section();
  const glm::dvec3 cursor = workspace_.cursor.position();
  const glm::dvec3 foot = cursor - section.normal * glm::dot(cursor - section.point, section.normal);
  for (const SlicePlane plane : SlicePlanes::all) {
    if (plane == canvas_.geometry().plane) continue;
    const PlaneAxes axes = workspace_.planes.axes(plane);
    const std::optional<QPointF> along = directionOf(axes);
    if (!along) continue;
    // The crosshair lies up to half a slice beside the volume's own slices; the plane through it cuts them elsewhere
    // than at its foot, unless the two are perpendicular.
    const glm::dvec3 across = axes.normal - section.normal * glm::dot(axes.normal, section.normal);
    const glm::dvec3 at = foot + across * (glm::dot(cursor - foot, axes.normal) / glm::dot(across, across));
    cuts.push_back({plane, canvas_.onSlice(at), *along});
  }
  return cuts;
}

std::vector<PlaneTool::Handle> PlaneTool::handles() const {
  std::vector<Handle> handles;
  if (!workspace_.document.hasVolume() || !workspace_.options.crosshair() || workspace_.tool.mode()) return handles;
  const QRectF view = canvas_.view();
  for (const PlaneCut& cut : cuts()) {
    if (!view.contains(cut.at)) continue;
    for (const double side : {-1.0, 1.0}) {
      const QPointF along = side * cut.along;
      const double way = wayOut(view, cut.at, along) - handleFromEdge;
      if (way >= handleFromCross) handles.push_back({cut.plane, cut.at + way * along});
    }
  }
  return handles;
}

double PlaneTool::angle(SlicePlane plane) const {
  const std::optional<QPointF> now = directionOf(workspace_.planes.axes(plane));
  const std::optional<QPointF> own = directionOf(planeAxes(workspace_.document.scene().volume->grid, plane));
  return now && own ? glm::degrees(betweenLines(angleOf(*now) - angleOf(*own))) : 0.0;
}

std::optional<PlaneTool::Handle> PlaneTool::handleAt(QPointF position) const {
  std::optional<Handle> nearest;
  double least = handleReach;
  for (const Handle& handle : handles())
    if (const double distance = QLineF(handle.at, position).length(); distance <= least) {
      least = distance;
      nearest = handle;
    }
  return nearest;
}

std::optional<Qt::CursorShape> PlaneTool::pointer(QPointF position) const {
  if (grip_) return Qt::ClosedHandCursor;
  return handleAt(position) ? std::optional(Qt::OpenHandCursor) : std::nullopt;
}

bool PlaneTool::press(const QMouseEvent& event) {
  if (event.modifiers() & ~(Qt::ShiftModifier | Qt::ControlModifier)) return false;
  grip_ = handleAt(event.position());
  if (!grip_) return false;
  for (const SlicePlane plane : SlicePlanes::all)
    before_[static_cast<std::size_t>(plane)] = workspace_.planes.axes(plane);
  pressed_ = mouse_ = event.position();
  lineBefore_ = angleOf(*directionOf(workspace_.planes.axes(grip_->plane)));
  drags_ = false;
  return true;
}

void PlaneTool::drag(const QMouseEvent& event) {
  if (!grip_ || !workspace_.document.hasVolume()) return;
  mouse_ = event.position();
  if (!drags_ && QLineF(pressed_, mouse_).length() <= clickSlack) return;
  SlicePlanes& planes = workspace_.planes;
  if (!std::exchange(drags_, true)) planes.setDragged(true);
  const QPointF centre = canvas_.onSlice(workspace_.cursor.position());
  const QPointF from = pressed_ - centre, to = mouse_ - centre;
  if (std::hypot(to.x(), to.y()) < 1.0) return;  // at the axis, where the mouse gives no direction
  double turn = angleOf(to) - angleOf(from);
  if (event.modifiers() & Qt::ShiftModifier) {
    constexpr double diagonal = glm::pi<double>() / 4.0;
    turn = std::round((lineBefore_ + turn) / diagonal) * diagonal - lineBefore_;
  }
  // Clockwise in the view is from its right towards down, whether or not the slice is mirrored there.
  const glm::dvec3 about = glm::normalize(glm::cross(canvas_.right(), canvas_.down()));
  for (const SlicePlane plane : SlicePlanes::all) {
    if (plane == canvas_.geometry().plane) continue;
    const bool both = event.modifiers() & Qt::ControlModifier;
    const PlaneAxes& before = before_[static_cast<std::size_t>(plane)];
    if (plane == grip_->plane || both) planes.setAxes(plane, turned(before, about, turn));
  }
}

void PlaneTool::release(const QMouseEvent&) { endDrag(); }

void PlaneTool::endDrag() {
  grip_.reset();
  drags_ = false;
  workspace_.planes.setDragged(false);
}

void PlaneTool::hover(const QMouseEvent&) {
  if (!std::exchange(hovers_, true)) canvas_.redraw();
}

void PlaneTool::leave() {
  endDrag();
  if (std::exchange(hovers_, false)) canvas_.redraw();
}

void PlaneTool::drawAngle(QPainter& painter, const QRectF& view) const {
  const QString text = PlaneToolWords::tr("%1°").arg(angle(grip_->plane), 0, 'f', 1);
  const QSizeF size = textSize(painter, text);
  QPointF at = mouse_ + QPointF(14.0, -14.0 - size.height());
  at.setX(std::clamp(at.x(), view.left(), std::max(view.left(), view.right() - size.width())));
  at.setY(std::clamp(at.y(), view.top(), std::max(view.top(), view.bottom() - size.height())));
  drawText(painter, QRectF(at, size), Qt::AlignCenter, text, planeColour(grip_->plane));
}

void PlaneTool::draw(QPainter& painter, const QRectF& view) const {
  if (!hovers_ && !grip_) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Handle& handle : handles()) {
    painter.setPen(QPen(QColor(0, 0, 0, 190), 1.5));
    painter.setBrush(planeColour(handle.plane));
    painter.drawEllipse(handle.at, handleRadius, handleRadius);
  }
  if (grip_ && drags_) drawAngle(painter, view);
  painter.restore();
}

}  // namespace fenestra::viewer
