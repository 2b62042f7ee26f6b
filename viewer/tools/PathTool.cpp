#include "viewer/tools/PathTool.h"

#include <cmath>
#include <span>
#include <utility>

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>

#include "viewer/model/Document.h"
#include "viewer/model/PathMode.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/tools/Canvas.h"
#include "viewer/tools/HandleDrag.h"

namespace fenestra::viewer {
namespace {

const QColor pathColour(255, 140, 90);
constexpr double nearSlice = 1.5;  ///< mm; as near as that, a path counts as on the slice

/// Draws a line through points of the world, with a dark rim.
void drawPathLine(QPainter& painter, const Canvas& canvas, std::span<const glm::dvec3> line) {
  const auto section = canvas.section();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto from = canvas.widgetFromWorld(line[i - 1]), to = canvas.widgetFromWorld(line[i]);
    if (!from || !to) continue;
    const bool isNear =
        !section || std::abs(glm::dot(0.5 * (line[i - 1] + line[i]) - section->point, section->normal)) <= nearSlice;
    QColor colour = pathColour;
    if (!isNear) colour.setAlpha(90);
    if (isNear) {
      painter.setPen(QPen(QColor(0, 0, 0, 160), 3.4, Qt::SolidLine, Qt::FlatCap));
      painter.drawLine(*from, *to);
    }
    painter.setPen(QPen(colour, isNear ? 1.8 : 1.2));
    painter.drawLine(*from, *to);
  }
}

void drawPathPoint(QPainter& painter, const Canvas& canvas, glm::dvec3 point, double radius, const QBrush& fill) {
  const auto at = canvas.widgetFromWorld(point);
  if (!at) return;
  painter.setPen(QPen(QColor(0, 0, 0, 200), 1.0));
  painter.setBrush(fill);
  painter.drawEllipse(*at, radius, radius);
}

}  // namespace

PathTool::PathTool(PathMode& mode, Document& document, const ViewOptions& options, const Canvas& canvas)
    : mode_(mode), document_(document), options_(options), canvas_(canvas) {}

bool PathTool::draws() const { return mode_.isDrawing() && canvas_.section(); }

bool PathTool::isHere(glm::dvec3 point) const {
  const auto section = canvas_.section();
  return section && std::abs(glm::dot(point - section->point, section->normal)) <= nearSlice;
}

std::optional<std::size_t> PathTool::pointAt(QPointF position) const {
  if (!options_.measures() || !canvas_.section() || mode_.isDrawing()) return std::nullopt;
  const std::vector<glm::dvec3>& path = document_.path();
  std::optional<std::size_t> nearest;
  double least = handleReach;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!isHere(path[i])) continue;
    const auto at = canvas_.widgetFromWorld(path[i]);
    const double distance = at ? QLineF(*at, position).length() : least;
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

bool PathTool::press(const QMouseEvent& event) {
  grip_.reset();
  dragging_ = false;
  if (!draws()) {
    if (event.modifiers() != Qt::NoModifier || event.type() == QEvent::MouseButtonDblClick) return false;
    const auto point = pointAt(event.position());
    const auto from = canvas_.pickSurface(event.position());
    if (point && from) grip_ = Grip{*point, event.position(), *from, document_.path(), document_.path()};
    return grip_.has_value();
  }
  // The second press of a double click: the first has set the last point.
  if (event.type() == QEvent::MouseButtonDblClick)
    mode_.finish();
  else if (const auto world = canvas_.pickSurface(event.position()))
    mode_.addPoint(*world);
  return true;
}

void PathTool::drag(const QMouseEvent& event) {
  if (!grip_ || (!dragging_ && QLineF(grip_->pressed, event.position()).length() <= clickSlack)) return;
  // Undone meanwhile, or another study has arrived: there is nothing to drag any more.
  if (document_.path() != grip_->held) return;
  const auto to = canvas_.pickSurface(event.position());
  if (!to) return;
  if (!std::exchange(dragging_, true)) document_.history().beginGesture();
  mode_.movePoint(grip_->before, grip_->point, *to - grip_->from);
  grip_->held = document_.path();
}

void PathTool::release(const QMouseEvent&) {
  if (dragging_) document_.history().endGesture();
  grip_.reset();
  dragging_ = false;
}

void PathTool::hover(const QMouseEvent& event) {
  if (draws()) mode_.hover(canvas_.pickSurface(event.position()));
}

void PathTool::leave() { mode_.hover({}); }

bool PathTool::key(const QKeyEvent& event) {
  if (!mode_.isDrawing()) return false;
  if (event.key() == Qt::Key_Backspace && event.modifiers() == Qt::NoModifier) return mode_.removeLast();
  if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) return mode_.finish();
  return false;
}

std::optional<Qt::CursorShape> PathTool::pointer(QPointF position) const {
  if (draws()) return Qt::CrossCursor;
  return pointAt(position) ? std::optional(Qt::SizeAllCursor) : std::nullopt;
}

void PathTool::draw(QPainter& painter, const QRectF&) const {
  if (!options_.measures()) return;
  const bool shows = mode_.hasPath() && !mode_.isDrawing();
  if (!shows && mode_.draft().empty()) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (shows) {
    drawPathLine(painter, canvas_, mode_.line());
    // Points that can be dragged; those of a centre line lie too close to be told apart.
    const std::vector<glm::dvec3>& path = document_.path();
    if (mode_.curve().length() > PathMode::reach * static_cast<double>(path.size() - 1))
      for (const glm::dvec3 point : path)
        if (isHere(point)) drawPathPoint(painter, canvas_, point, 3.0, pathColour);
    drawPathPoint(painter, canvas_, mode_.curve().place(mode_.place()).point, 4.0, Qt::white);
  } else {
    std::vector<glm::dvec3> points = mode_.draft();
    if (mode_.hovered()) points.push_back(*mode_.hovered());
    drawPathLine(painter, canvas_, lineOf(reformat::PathCurve(points), 2.0));
    for (const glm::dvec3 point : mode_.draft()) drawPathPoint(painter, canvas_, point, 3.0, pathColour);
  }
  painter.restore();
}

}  // namespace fenestra::viewer
