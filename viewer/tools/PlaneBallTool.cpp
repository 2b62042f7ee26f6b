#include "viewer/tools/PlaneBallTool.h"

#include <cmath>

#include <QMouseEvent>

#include "viewer/model/Workspace.h"
#include "viewer/style/Overlay.h"
#include "viewer/tools/Canvas.h"
#include "viewer/tools/CutPolygon.h"
#include "viewer/tools/HandleDrag.h"

namespace fenestra::viewer {
namespace {

constexpr double ballDistance = 0.3;  ///< from the crosshair, over the radius of the volume

}  // namespace

PlaneBallTool::PlaneBallTool(Workspace& workspace, const Canvas& canvas) : workspace_(workspace), canvas_(canvas) {}

PlaneBallTool::Handle PlaneBallTool::handleOf(SlicePlane plane) const {
  const glm::dvec3 normal = workspace_.planes.axes(plane).normal;
  const glm::dvec3 along = glm::dot(normal, canvas_.axes().forward) > 0.0 ? -normal : normal;
  const double length = ballDistance * workspace_.document.scene().volume->grid.boundingRadius();
  return {plane, workspace_.cursor.position() + length * along, along};
}

std::vector<PlaneBallTool::Handle> PlaneBallTool::handles() const {
  std::vector<Handle> handles;
  if (!workspace_.document.hasVolume() || !workspace_.options.planes() || workspace_.tool.mode()) return handles;
  for (const SlicePlane plane : SlicePlanes::all) {
    handles.push_back(handleOf(plane));
    // A plane that is turned past the line of sight keeps its ball under the mouse.
    if (grip_ && grip_->plane == plane && glm::dot(handles.back().along, grip_->along) < 0.0) {
      const glm::dvec3 cursor = workspace_.cursor.position();
      handles.back() = {plane, 2.0 * cursor - handles.back().at, -handles.back().along};
    }
  }
  return handles;
}

std::optional<Qt::CursorShape> PlaneBallTool::pointer(QPointF position) const {
  if (grip_) return Qt::ClosedHandCursor;
  return handleNear(handles(), canvas_, position) ? std::optional(Qt::OpenHandCursor) : std::nullopt;
}

bool PlaneBallTool::press(const QMouseEvent& event) {
  if (event.modifiers() != Qt::NoModifier) return false;
  grip_ = handleNear(handles(), canvas_, event.position());
  if (!grip_) return false;
  before_ = workspace_.planes.axes(grip_->plane);
  pressed_ = event.position();
  workspace_.planes.setDragged(true);
  return true;
}

void PlaneBallTool::drag(const QMouseEvent& event) {
  if (!grip_ || !workspace_.document.hasVolume()) return;
  const auto [right, up, forward] = canvas_.axes();
  const QPointF perRight = canvas_.pixelsPerMm(grip_->at, right), moved = event.position() - pressed_;
  const double pixels = std::hypot(perRight.x(), perRight.y());
  if (!(pixels > 0.0)) return;
  const glm::dvec3 from = grip_->at - workspace_.cursor.position();
  const glm::dvec3 to = from + (right * moved.x() - up * moved.y()) / pixels;
  // The smallest turn that brings the ball's direction there.
  const glm::dvec3 about = glm::cross(from, to);
  const double sine = glm::length(about), cosine = glm::dot(from, to);
  if (!(sine > 1e-9 * glm::dot(from, from))) return workspace_.planes.setAxes(grip_->plane, before_);
  workspace_.planes.setAxes(grip_->plane, turned(before_, about / sine, std::atan2(sine, cosine)));
}

void PlaneBallTool::release(const QMouseEvent&) { leave(); }

void PlaneBallTool::leave() {
  if (!grip_) return;
  grip_.reset();
  workspace_.planes.setDragged(false);
}

void PlaneBallTool::drawOutline(QPainter& painter, SlicePlane plane) const {
  const glm::dvec3 normal = workspace_.planes.axes(plane).normal;
  const std::vector<glm::dvec3> polygon =
      cutPolygon(workspace_.document.scene().volume->grid, {normal, glm::dot(normal, workspace_.cursor.position())});
  const auto line = [&](glm::dvec3 from, glm::dvec3 to) {
    const auto a = canvas_.widgetFromWorld(from), b = canvas_.widgetFromWorld(to);
    if (!a || !b) return;
    painter.setPen(QPen(QColor(0, 0, 0, 150), 3.0));
    painter.drawLine(*a, *b);
    painter.setPen(QPen(planeColour(plane), 1.4));
    painter.drawLine(*a, *b);
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) line(polygon[i], polygon[(i + 1) % polygon.size()]);
}

void PlaneBallTool::draw(QPainter& painter, const QRectF&) const {
  const std::vector<Handle> all = handles();
  if (all.empty()) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const auto foot = canvas_.widgetFromWorld(workspace_.cursor.position());
  for (const Handle& handle : all) {
    drawOutline(painter, handle.plane);
    const auto at = canvas_.widgetFromWorld(handle.at);
    if (!at) continue;
    painter.setPen(QPen(planeColour(handle.plane), 1.4));
    if (foot) painter.drawLine(*foot, *at);
    painter.setPen(QPen(QColor(0, 0, 0, 190), 1.5));
    painter.setBrush(planeColour(handle.plane));
    painter.drawEllipse(*at, handleRadius, handleRadius);
  }
  painter.restore();
}

}  // namespace fenestra::viewer
