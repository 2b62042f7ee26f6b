#include "viewer/tools/MeasureTool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QLineF>
#include <QMouseEvent>

#include "viewer/model/Document.h"
#include "viewer/model/MeasureMode.h"
#include "viewer/model/MeasureText.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/tools/Canvas.h"

namespace fenestra::viewer {
namespace {

// Device-independent pixels.
constexpr double measureReach = 7.0, lineReach = 5.0;

double distanceTo(const QLineF& line, QPointF point) {
  const QPointF along = line.p2() - line.p1(), from = point - line.p1();
  const double square = QPointF::dotProduct(along, along);
  const double share = square > 0.0 ? std::clamp(QPointF::dotProduct(from, along) / square, 0.0, 1.0) : 0.0;
  return QLineF(point, line.p1() + share * along).length();
}

/// Where a measure's lines stand, as drawMeasure() draws them in a view; empty without any.
QRectF textBoxIn(const ShownMeasure& measure, const QRectF& view) {
  const QFontMetricsF metrics(QGuiApplication::font());
  QSizeF size;
  for (const QString& each : measure.lines)
    size = {std::max(size.width(), metrics.horizontalAdvance(each)), size.height() + metrics.height()};
  return measure.lines.isEmpty() ? QRectF() : textBoxOf(measure, size, view);
}

}  // namespace

MeasureTool::MeasureTool(MeasureMode& mode, Document& document, const ViewOptions& options, const SliceCanvas& canvas)
    : mode_(mode), document_(document), options_(options), canvas_(canvas) {}

bool MeasureTool::liesHere(const Measure& measure) const {
  return options_.measures() && sliceOf(measure, canvas_.geometry()) == canvas_.slice();
}

bool MeasureTool::isDrawing() const { return mode_.draft() && liesHere(*mode_.draft()); }

std::optional<ShownMeasure> MeasureTool::shown(const Measure& measure, const MeasureValues& values) const {
  if (!liesHere(measure)) return std::nullopt;
  ShownMeasure shown{measure.kind, {}, linesOf(measure, values, *document_.scene().volume), false};
  for (const glm::dvec3 handle : handlesOf(measure)) shown.handles << canvas_.onSlice(handle);
  return shown;
}

std::optional<MeasureTool::Grip> MeasureTool::gripAt(QPointF position) const {
  std::optional<Grip> line;
  for (std::size_t index = document_.measures().size(); index-- > 0;) {
    const std::optional<ShownMeasure> measure = shown(document_.measures()[index], document_.measured(index));
    if (!measure) continue;
    for (qsizetype handle = 0; handle < measure->handles.size(); ++handle)
      if (QLineF(measure->handles[handle], position).length() <= measureReach)
        return Grip{index, static_cast<std::size_t>(handle)};
    // A mark is grabbed by its text, too. Not while something is drawn, which may begin there.
    if (isMark(measure->kind) && !mode_.kind() && !line && textBoxIn(*measure, canvas_.view()).contains(position))
      line = Grip{index, {}};
    const QPolygonF outline = outlineOf(*measure);
    for (qsizetype corner = 1; corner < outline.size() && !line; ++corner)
      if (distanceTo({outline[corner - 1], outline[corner]}, position) <= lineReach) line = Grip{index, {}};
  }
  return line;
}

std::optional<std::size_t> MeasureTool::measureAt(QPointF position) const {
  const std::optional<Grip> grip = gripAt(position);
  return grip ? std::optional(grip->measure) : std::nullopt;
}

std::optional<Qt::CursorShape> MeasureTool::pointer(QPointF position) const {
  if (mode_.draft()) return Qt::CrossCursor;
  if (const std::optional<Grip> grip = gripAt(position)) return grip->handle ? Qt::SizeAllCursor : Qt::OpenHandCursor;
  return mode_.kind() ? std::optional(Qt::CrossCursor) : std::nullopt;
}

bool MeasureTool::press(const QMouseEvent& event) {
  if (!document_.hasVolume()) return false;
  pressed_ = event.position();
  dragging_ = false;
  if (isDrawing()) return true;
  if (event.modifiers() == Qt::NoModifier) grip_ = gripAt(event.position());
  if (grip_) {
    mode_.select(grip_->measure);
    gripped_ = canvas_.worldFromWidget(event.position());
    held_ = document_.measures();
    return true;
  }
  mode_.select(std::nullopt);
  if (!mode_.kind()) return false;
  const SliceGeometry& geometry = canvas_.geometry();
  const glm::dvec3 at = canvas_.worldFromWidget(event.position());
  std::vector<glm::dvec3> points(std::min<std::size_t>(pointCount(*mode_.kind()), 2), at);
  mode_.setDraft(
      Measure{*mode_.kind(), std::move(points), glm::normalize(geometry.right), glm::normalize(geometry.down)});
  return true;
}

void MeasureTool::drag(const QMouseEvent& event) {
  if (!grip_) return hover(event);
  if (!dragging_ && QLineF(pressed_, event.position()).length() <= clickSlack) return;
  // Undone or deleted meanwhile, or another study has arrived: there is nothing to drag any more.
  if (document_.measures() != held_) return;
  if (!std::exchange(dragging_, true)) document_.history().beginGesture();
  moveGrip(canvas_.worldFromWidget(event.position()));
}

void MeasureTool::hover(const QMouseEvent& event) {
  if (!document_.hasVolume() || !isDrawing()) return;
  Measure draft = *mode_.draft();
  draft.points.back() = canvas_.worldFromWidget(event.position());
  mode_.setDraft(std::move(draft));
}

void MeasureTool::moveGrip(glm::dvec3 to) {
  std::vector<Measure> measures = document_.measures();
  Measure& measure = measures.at(grip_->measure);
  measure =
      grip_->handle ? withHandleAt(std::move(measure), *grip_->handle, to) : movedBy(std::move(measure), to - gripped_);
  gripped_ = to;
  document_.setMeasures(std::move(measures), MeasureMode::tr("Move measure"));
  held_ = document_.measures();
}

void MeasureTool::release(const QMouseEvent& event) {
  if (grip_) {
    grip_.reset();
    if (dragging_) document_.history().endGesture();
    return;
  }
  if (!isDrawing()) return;
  Measure draft = *mode_.draft();
  if (draft.kind == MeasureKind::Text) return mode_.finishDraft();  // which a click places
  const QPointF before = canvas_.onSlice(draft.points[draft.points.size() - 2]);
  if (QLineF(before, event.position()).length() <= clickSlack) return;  // the first click of two
  draft.points.back() = canvas_.worldFromWidget(event.position());
  const bool isWhole = draft.points.size() == pointCount(draft.kind);
  if (!isWhole) draft.points.push_back(draft.points.back());
  mode_.setDraft(std::move(draft));
  if (isWhole) mode_.finishDraft();
}

void MeasureTool::draw(QPainter& painter, const QRectF& view) const {
  for (std::size_t index = 0; index < document_.measures().size(); ++index)
    if (std::optional<ShownMeasure> measure = shown(document_.measures()[index], document_.measured(index))) {
      measure->selected = mode_.selected() == index;
      drawMeasure(painter, *measure, view);
    }
  if (!isDrawing()) return;
  const Measure& draft = *mode_.draft();
  // An angle's first arm is a distance until the second is drawn.
  Measure sofar = draft;
  if (draft.points.size() < pointCount(draft.kind)) sofar.kind = MeasureKind::Distance;
  if (const auto measure = shown(sofar, valuesOf(sofar, *document_.scene().volume)))
    drawMeasure(painter, *measure, view);
}

}  // namespace fenestra::viewer
