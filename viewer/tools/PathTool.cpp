#include "viewer/tools/PathTool.h"

#include <cmath>
#include <span>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "viewer/model/PathMode.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/tools/Canvas.h"

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

PathTool::PathTool(PathMode& mode, const ViewOptions& options, const Canvas& canvas)
    : mode_(mode), options_(options), canvas_(canvas) {}

bool PathTool::draws() const { return mode_.isDrawing() && canvas_.section(); }

bool PathTool::press(const QMouseEvent& event) {
  if (!draws()) return false;
  // The second press of a double click: the first has set the last point.
  if (event.type() == QEvent::MouseButtonDblClick)
    mode_.finish();
  else if (const auto world = canvas_.pickSurface(event.position()))
    mode_.addPoint(*world);
  return true;
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

std::optional<Qt::CursorShape> PathTool::pointer(QPointF) const {
  return draws() ? std::optional(Qt::CrossCursor) : std::nullopt;
}

void PathTool::draw(QPainter& painter, const QRectF&) const {
  if (!options_.measures()) return;
  const bool shows = mode_.hasPath() && !mode_.isDrawing();
  if (!shows && mode_.draft().empty()) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (shows) {
    drawPathLine(painter, canvas_, mode_.line());
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
