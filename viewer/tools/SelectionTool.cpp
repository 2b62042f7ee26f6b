#include "viewer/tools/SelectionTool.h"

#include <algorithm>

#include <QMouseEvent>

#include "viewer/model/Document.h"
#include "viewer/model/SelectionBrush.h"
#include "viewer/tools/Canvas.h"

namespace fenestra::viewer {
namespace {

/// Share of the radius: an anchor nearer to the last one would change hardly any voxel.
constexpr double leastStep = 0.2;

}  // namespace

SelectionTool::SelectionTool(SelectionBrush& brush, Document& document, Canvas& canvas)
    : brush_(brush), document_(document), canvas_(canvas) {}

bool SelectionTool::isActive() const { return brush_.isActive() && document_.hasVolume(); }

bool SelectionTool::press(const QMouseEvent& event) {
  const Qt::KeyboardModifiers others = event.modifiers() & ~Qt::KeyboardModifiers(Qt::ShiftModifier);
  if (!isActive() || others != Qt::NoModifier) return false;
  stroke_ = SelectionStroke{
      {}, brush_.settings().radius, brush_.settings().softness, !(event.modifiers() & Qt::ShiftModifier)};
  paintTo(event.position());
  return true;
}

void SelectionTool::drag(const QMouseEvent& event) {
  mouse_ = event.position();
  paintTo(*mouse_);
  canvas_.redraw();
}

void SelectionTool::release(const QMouseEvent& event) {
  paintTo(event.position());
  SelectionStroke painted = std::move(*stroke_);
  stroke_.reset();
  if (!painted.anchors.empty()) document_.paintSelection(std::move(painted));
  canvas_.redraw();
}

void SelectionTool::hover(const QMouseEvent& event) {
  mouse_ = event.position();
  if (!isActive()) return;
  if (event.buttons() == Qt::NoButton) under_ = canvas_.pickVoxel(*mouse_);
  canvas_.redraw();
}

void SelectionTool::leave() {
  mouse_.reset();
  under_.reset();
  canvas_.redraw();
}

std::optional<Qt::CursorShape> SelectionTool::pointer(QPointF) const {
  return isActive() ? std::optional(Qt::CrossCursor) : std::nullopt;
}

void SelectionTool::paintTo(QPointF position) {
  under_ = canvas_.pickVoxel(position);
  if (!under_) return;
  std::vector<glm::dvec3>& anchors = stroke_->anchors;
  if (anchors.empty() || glm::distance(anchors.back(), *under_) > leastStep * stroke_->radius)
    anchors.push_back(*under_);
}

void SelectionTool::draw(QPainter& painter, const QRectF&) const {
  if (!isActive() || !mouse_) return;
  const SelectionBrushSettings& settings = brush_.settings();
  const QColor colour = !under_                     ? QColor(160, 164, 170)
                        : stroke_ && !stroke_->adds ? QColor(255, 170, 110)
                                                    : QColor(140, 230, 150);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (stroke_ && !stroke_->anchors.empty()) {
    QPolygonF line;
    for (const glm::dvec3 anchor : stroke_->anchors)
      if (const auto at = canvas_.widgetFromWorld(anchor)) line << *at;
    QColor trail = colour;
    trail.setAlpha(90);
    const double width = 2.0 * canvas_.pixelsOf(stroke_->radius, stroke_->anchors.back());
    painter.setPen(QPen(trail, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    line.size() > 1 ? painter.drawPolyline(line) : painter.drawPoints(line);
  }
  if (under_) {
    painter.setBrush(Qt::NoBrush);
    const double radius = canvas_.pixelsOf(settings.radius, *under_);
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 170), 3.5), QPen(colour, 1.5)}) {
      painter.setPen(pen);
      painter.drawEllipse(*mouse_, radius, radius);
    }
    painter.setPen(QPen(colour, 1.0, Qt::DotLine));
    const double core = radius * (1.0 - settings.softness);
    if (settings.softness > 0.0 && core >= 2.0) painter.drawEllipse(*mouse_, core, core);
  }
  painter.restore();
}

}  // namespace fenestra::viewer
