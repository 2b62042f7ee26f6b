#include "viewer/style/MeasureDrawing.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "viewer/style/Overlay.h"

namespace fenestra::viewer {
namespace {

constexpr double gap = 8.0;  ///< device-independent pixels between line and text

QPointF unit(QPointF direction) {
  const double length = std::hypot(direction.x(), direction.y());
  return length > 1e-9 ? direction / length : QPointF(1.0, 0.0);
}

/// The box of that size that begins `gap` beyond a point in a direction, behind the line through the point at a right
/// angle to the direction.
QRectF beyond(QPointF point, QPointF direction, QSizeF size) {
  const QPointF way = unit(direction);
  const double reach = 0.5 * (size.width() * std::abs(way.x()) + size.height() * std::abs(way.y()));
  const QPointF centre = point + way * (gap + reach);
  return {centre - QPointF(0.5 * size.width(), 0.5 * size.height()), size};
}

QPointF across(QPointF direction) { return {-direction.y(), direction.x()}; }

/// Places for the text, the best first. None meets the line.
QList<QRectF> candidates(const ShownMeasure& measure, QSizeF size) {
  const QPolygonF& at = measure.handles;
  if (measure.kind == MeasureKind::Text) return {{at[0] + QPointF(gap, -0.5 * size.height()), size}};
  if (measure.kind == MeasureKind::Distance || measure.kind == MeasureKind::Arrow) {
    const QPointF along = at[1] - at[0], middle = 0.5 * (at[0] + at[1]);
    QList<QRectF> boxes{beyond(at[1], along, size)};
    // What an arrow points at stays free.
    if (measure.kind == MeasureKind::Distance) boxes << beyond(at[0], -along, size);
    return boxes << beyond(middle, across(along), size) << beyond(middle, -across(along), size);
  }
  if (measure.kind == MeasureKind::Angle) {
    const QPointF a = unit(at[0] - at[1]), b = unit(at[2] - at[1]);
    // Both arms of an angle lie on one side of its vertex, except those of a straight angle.
    const QPointF away = -(a + b);
    const QPointF straight = across(a);
    return {beyond(at[1], std::hypot(away.x(), away.y()) > 1e-3 ? away : straight, size), beyond(at[0], a, size),
            beyond(at[2], b, size)};
  }
  const QRectF box = outlineOf(measure).boundingRect();
  const double below = box.bottom() + gap, above = box.top() - gap - size.height();
  return {{{box.right() + gap, box.bottom() - size.height()}, size},
          {{box.left() - gap - size.width(), box.bottom() - size.height()}, size},
          {{box.left(), below}, size},
          {{box.left(), above}, size}};
}

}  // namespace

QPolygonF outlineOf(const ShownMeasure& measure) {
  if (!isRegion(measure.kind)) return measure.handles;
  QPolygonF outline = measure.handles;
  if (measure.kind == MeasureKind::Ellipse) {
    const QPointF centre = 0.5 * (outline[0] + outline[2]), a = outline[1] - centre, b = outline[2] - centre;
    constexpr int corners = 72;
    outline.clear();
    for (int corner = 0; corner < corners; ++corner) {
      const double turn = 2.0 * glm::pi<double>() * corner / corners;
      outline << centre + std::cos(turn) * a + std::sin(turn) * b;
    }
  }
  outline << outline.front();
  return outline;
}

QPolygonF headOf(const ShownMeasure& arrow) {
  const QPointF tip = arrow.handles[0], back = unit(arrow.handles[1] - tip);
  constexpr double length = 11.0, halfWidth = 4.5;  // device-independent pixels
  const QPointF base = tip + length * back, side = halfWidth * across(back);
  return {{base + side, tip, base - side}};
}

QRectF textBoxOf(const ShownMeasure& measure, QSizeF text, const QRectF& view) {
  const QList<QRectF> boxes = candidates(measure, text);
  const auto inside = std::find_if(boxes.begin(), boxes.end(), [&](const QRectF& box) { return view.contains(box); });
  if (inside != boxes.end()) return *inside;
  QRectF box = boxes.front();
  box.moveLeft(std::clamp(box.left(), view.left(), std::max(view.left(), view.right() - box.width())));
  box.moveTop(std::clamp(box.top(), view.top(), std::max(view.top(), view.bottom() - box.height())));
  return box;
}

void drawMeasure(QPainter& painter, const ShownMeasure& measure, const QRectF& view) {
  const QColor colour = measure.selected ? QColor(120, 235, 255) : QColor(255, 236, 90);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const QPolygonF outline = outlineOf(measure);
  for (const QPen& pen : {QPen(QColor(0, 0, 0, 200), 3.2), QPen(colour, 1.4)}) {
    painter.setPen(pen);
    painter.drawPolyline(outline);
    if (measure.kind == MeasureKind::Arrow) painter.drawPolyline(headOf(measure));
    for (const QPointF& handle : measure.handles) {
      // What an arrow points at stays free.
      if (measure.kind == MeasureKind::Arrow && !measure.selected) break;
      const double radius = measure.selected ? 4.0 : 2.5;
      painter.drawEllipse(handle, radius, radius);
    }
  }
  painter.restore();

  QSizeF size;
  for (const QString& line : measure.lines) {
    const QSizeF one = textSize(painter, line);
    size = {std::max(size.width(), one.width()), size.height() + one.height()};
  }
  if (measure.lines.isEmpty()) return;
  QRectF row = textBoxOf(measure, size, view);
  for (const QString& line : measure.lines) {
    row.setHeight(textSize(painter, line).height());
    drawText(painter, row, Qt::AlignLeft | Qt::AlignTop, line, colour);
    row.moveTop(row.bottom());
  }
}

}  // namespace fenestra::viewer
