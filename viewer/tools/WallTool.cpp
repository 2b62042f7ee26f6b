#include "viewer/tools/WallTool.h"

#include <limits>

#include <QMouseEvent>

#include "rendering/scene/Walls.h"
#include "viewer/model/ActiveTool.h"
#include "viewer/model/Document.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/style/Overlay.h"
#include "viewer/tools/Canvas.h"
#include "viewer/tools/HandleDrag.h"

namespace fenestra::viewer {

WallTool::WallTool(const Document& document, SliceCursor& cursor, const ViewOptions& options, const ActiveTool& active,
                   const Canvas& canvas)
    : document_(document), cursor_(cursor), options_(options), active_(active), canvas_(canvas) {}

std::vector<WallTool::Handle> WallTool::handles() const {
  std::vector<Handle> handles;
  if (!document_.hasVolume() || !options_.crosshair() || active_.mode()) return handles;
  std::optional<MethodStages::Walls> walls = wallsOf(document_.look());
  if (!walls) return handles;
  walls->placement = WallPlacement::Inside;  // where the slices lie, which does not depend on the camera
  const Grid& grid = document_.scene().volume->grid;
  const glm::dvec3 away = canvas_.axes().forward;
  for (const Wall& wall : wallsAt(*walls, grid, {.crosshair = cursor_.position()}, Camera())) {
    const glm::dvec2 last = glm::dvec2(wall.size) - 0.5, middle = 0.5 * (last - 0.5);
    Handle handle{wall.plane, {}, grid.direction[wall.axis]};
    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::dvec2 place : {glm::dvec2(-0.5, middle.y), glm::dvec2(last.x, middle.y), glm::dvec2(middle.x, -0.5),
                                   glm::dvec2(middle.x, last.y)}) {
      const glm::dvec3 world = wall.worldFromPlace(place);
      const double depth = glm::dot(world, away);
      if (depth < nearest) {
        nearest = depth;
        handle.at = world;
      }
    }
    handles.push_back(handle);
  }
  return handles;
}

std::optional<WallTool::Handle> WallTool::handleAt(QPointF position) const {
  return handleNear(handles(), canvas_, position);
}

std::optional<Qt::CursorShape> WallTool::pointer(QPointF position) const {
  if (grip_) return Qt::ClosedHandCursor;
  return handleAt(position) ? std::optional(Qt::OpenHandCursor) : std::nullopt;
}

bool WallTool::press(const QMouseEvent& event) {
  if (event.modifiers() != Qt::NoModifier) return false;
  grip_ = handleAt(event.position());
  if (!grip_) return false;
  before_ = cursor_.position();
  pressed_ = event.position();
  return true;
}

void WallTool::drag(const QMouseEvent& event) {
  if (!document_.hasVolume()) return;
  const double mm = draggedAlong(canvas_, grip_->at, grip_->along, event.position() - pressed_);
  cursor_.moveTo(before_ + mm * grip_->along);
}

void WallTool::release(const QMouseEvent&) { grip_.reset(); }

void WallTool::draw(QPainter& painter, const QRectF&) const {
  const std::vector<Handle> all = handles();
  if (all.empty()) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Handle& handle : all) {
    const auto at = canvas_.widgetFromWorld(handle.at);
    if (!at) continue;
    painter.setPen(QPen(QColor(0, 0, 0, 190), 1.5));
    painter.setBrush(planeColour(handle.plane));
    painter.drawRect(QRectF(*at - QPointF(handleRadius, handleRadius), QSizeF(2.0 * handleRadius, 2.0 * handleRadius)));
  }
  painter.restore();
}

}  // namespace fenestra::viewer
