#include "viewer/tools/CarveTool.h"

#include <algorithm>

#include <QMouseEvent>

#include "rendering/settings/SettingWords.h"
#include "viewer/model/Carving.h"
#include "viewer/model/Document.h"
#include "viewer/model/Translation.h"
#include "viewer/tools/Canvas.h"

namespace fenestra::viewer {
namespace {

constexpr double mostBetweenPoints = 2.0;  ///< mm, in strokes of a saw or a plane

}  // namespace

CarveTool::CarveTool(Carving& carving, Document& document, Canvas& canvas)
    : carving_(carving), document_(document), canvas_(canvas) {}

bool CarveTool::press(const QMouseEvent& event) {
  if (!carving_.isActive() || event.modifiers() & Qt::ControlModifier) return false;
  const std::optional<glm::dvec3> at = canvas_.pickSurface(event.position());
  mouse_ = event.position();
  under_ = at;
  if (!at) return true;
  const bool bends = event.modifiers() & Qt::ShiftModifier;
  if (bends && !lastPlane()) return true;
  stroke_ = {*at};
  if (bends) bentFrom_ = event.position();
  canvas_.redraw();
  return true;
}

void CarveTool::drag(const QMouseEvent& event) {
  mouse_ = event.position();
  // While a plane is bent, the line to the mouse shows how far.
  if (!stroke_.empty() && !bentFrom_) extendTo(*mouse_);
  canvas_.redraw();
}

void CarveTool::release(const QMouseEvent& event) {
  if (stroke_.empty()) return;
  if (bentFrom_)
    bend(event.position());
  else
    finish(event.position());
  stroke_.clear();
  bentFrom_.reset();
  canvas_.redraw();
}

void CarveTool::hover(const QMouseEvent& event) {
  if (!carving_.isActive()) return;
  mouse_ = event.position();
  if (event.buttons() == Qt::NoButton) under_ = canvas_.pickSurface(*mouse_);
  canvas_.redraw();
}

void CarveTool::leave() {
  mouse_.reset();
  canvas_.redraw();
}

std::optional<Qt::CursorShape> CarveTool::pointer(QPointF) const {
  return carving_.isActive() ? std::optional(Qt::CrossCursor) : std::nullopt;
}

void CarveTool::extendTo(QPointF position) {
  const std::optional<glm::dvec3> at = canvas_.pickSurface(position);
  if (!at) return;
  under_ = at;
  // A nearer point would change next to nothing.
  const CarvingSettings& settings = carving_.settings();
  const bool isSolid = settings.shape == RemovalShape::Ball || settings.shape == RemovalShape::Box;
  const double least = isSolid ? settings.size / 8.0 : std::min(0.5 * settings.size, mostBetweenPoints);
  if (glm::distance(stroke_.back(), *at) >= least) stroke_.push_back(*at);
}

void CarveTool::finish(QPointF position) {
  extendTo(position);
  Removals removals = document_.removals();
  removals.push_back(carvedAlong(stroke_, carving_.settings(), canvas_.axesAt(stroke_.front())));
  const QString shape = translated(wordOf(carving_.settings().shape).name);
  document_.setRemovals(std::move(removals), Carving::tr("Carve: %1").arg(shape));
}

void CarveTool::bend(QPointF position) {
  const Removal* plane = lastPlane();
  const double scale = canvas_.pixelsOf(1.0, stroke_.front());
  if (!plane || !(scale > 0.0)) return;
  const glm::dvec2 moved = glm::dvec2(position.x() - bentFrom_->x(), bentFrom_->y() - position.y()) / scale;
  Removals removals = document_.removals();
  const double distance = bentBy(*plane, moved, canvas_.axesAt(stroke_.front()));
  if (distance == 0.0) return;
  removals.back().bends.push_back({stroke_.front(), distance, carving_.settings().size});
  document_.setRemovals(std::move(removals), Carving::tr("Bend the plane"));
}

const Removal* CarveTool::lastPlane() const {
  const Removals& removals = document_.removals();
  return !removals.empty() && removals.back().shape == RemovalShape::Plane ? &removals.back() : nullptr;
}

void CarveTool::draw(QPainter& painter, const QRectF&) const {
  if (!carving_.isActive() || !mouse_) return;
  const CarvingSettings& settings = carving_.settings();
  const QColor colour = under_ ? QColor(255, 170, 110) : QColor(160, 164, 170), rim(0, 0, 0, 170);
  QPolygonF line;
  for (const glm::dvec3& point : stroke_)
    if (const std::optional<QPointF> at = canvas_.widgetFromWorld(point)) line << *at;
  if (bentFrom_) line << *mouse_;
  const double radius = under_ ? canvas_.pixelsOf(settings.size, *under_) : 0.0;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const QPen& pen : {QPen(rim, 3.5), QPen(colour, 1.5)}) {
    painter.setPen(pen);
    painter.drawPolyline(line);
    if (settings.shape == RemovalShape::Ball || settings.shape == RemovalShape::Plane)
      painter.drawEllipse(*mouse_, radius, radius);
    else if (settings.shape == RemovalShape::Box)
      painter.drawRect(QRectF(mouse_->x() - radius, mouse_->y() - radius, 2.0 * radius, 2.0 * radius));
    else
      painter.drawEllipse(*mouse_, 0.5 * radius, 0.5 * radius);
  }
  painter.restore();
}

}  // namespace fenestra::viewer
