#include "viewer/tools/BrushTool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "viewer/model/Brush.h"
#include "viewer/model/Document.h"
#include "viewer/style/Overlay.h"
#include "viewer/tools/Canvas.h"

namespace fenestra::viewer {
namespace {

/// Change of ln(depth) per eighth of a degree: a notch of 15° changes the depth by a tenth.
constexpr double wheelRate = 0.0008;
constexpr double dragRate = 0.01;  ///< change of ln(depth) per pixel

}  // namespace

BrushTool::BrushTool(Brush& brush, Document& document, PictureCanvas& canvas)
    : brush_(brush), document_(document), canvas_(canvas) {}

bool BrushTool::press(const QMouseEvent& event) {
  if (!brush_.isActive() || event.modifiers() & Qt::ControlModifier) return false;
  if (event.modifiers() & (Qt::ShiftModifier | Qt::AltModifier)) {
    deepening_ = event.position();
    return true;
  }
  picture_ = canvas_.picture();
  if (picture_.empty()) return true;
  const BrushSettings& settings = brush_.settings();
  before_ = document_.strokes();
  stroke_ = BrushStroke{.mode = settings.mode,
                        .anchors = {},
                        .softness = settings.softness,
                        .depth = settings.depth,
                        .amount = settings.amount,
                        .toSurface = settings.toSurface && settings.mode == BrushMode::Restore,
                        .coversFocus = settings.coversFocus,
                        .view = settings.thisViewOnly ? canvas_.camera() : -1};
  document_.history().beginGesture();
  paintTo(event.position());
  return true;
}

void BrushTool::drag(const QMouseEvent& event) {
  mouse_ = event.position();
  if (deepening_) {
    brush_.scaleDepth(std::exp(dragRate * (deepening_->y() - mouse_->y())));
    deepening_ = mouse_;
    return;
  }
  if (isPainting()) paintTo(*mouse_);
  canvas_.redraw();
}

void BrushTool::release(const QMouseEvent& event) {
  if (isPainting()) {
    paintTo(event.position());
    finish();
  }
  deepening_.reset();
}

void BrushTool::hover(const QMouseEvent& event) {
  mouse_ = event.position();
  if (!brush_.isActive()) return;
  if (event.buttons() == Qt::NoButton) refresh();
  canvas_.redraw();
}

bool BrushTool::wheel(const QWheelEvent& event) {
  if (!brush_.isActive() || !(event.modifiers() & (Qt::ShiftModifier | Qt::AltModifier))) return false;
  // With Alt held, Qt reports a vertical wheel as a horizontal one.
  const QPoint angle = event.angleDelta();
  brush_.scaleDepth(std::exp(wheelRate * (angle.y() != 0 ? angle.y() : angle.x())));
  return true;
}

bool BrushTool::key(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Space || isPainting() || !obstacle_ || remedyOf(*obstacle_).isEmpty()) return false;
  applyRemedy(*obstacle_, brush_, document_);
  refresh();
  canvas_.redraw();
  return true;
}

void BrushTool::leave() {
  mouse_.reset();
  obstacle_.reset();
  canvas_.redraw();
}

std::optional<Qt::CursorShape> BrushTool::pointer(QPointF) const {
  return brush_.isActive() ? std::optional(Qt::CrossCursor) : std::nullopt;
}

void BrushTool::paintTo(QPointF position) {
  std::optional<glm::dvec3> last;
  if (!stroke_->anchors.empty()) last = stroke_->anchors.back();
  const std::optional<BrushPoint> point = canvas_.pickBrush(position, stroke_->mode, last);
  if (!point) return;
  // The whole stroke has one radius in mm: that of the ring where the stroke begins.
  if (stroke_->anchors.empty()) stroke_->radius = brush_.settings().radius * point->pixelSize;
  if (!extend(*stroke_, point->anchor)) return;
  under_ = point;
  BrushStrokes strokes = before_;
  strokes.push_back(*stroke_);
  document_.setStrokes(std::move(strokes), Brush::tr("Brush: %1").arg(nameOf(stroke_->mode).toLower()));
}

void BrushTool::finish() {
  document_.history().endGesture();
  const bool painted = document_.strokes() != before_;
  stroke_.reset();
  before_.clear();
  // A stroke that leaves the picture unchanged is dropped: nothing was cut away there, or there is no context layer.
  if (painted && canvas_.picture() == picture_) document_.history().takeBack();
  picture_.clear();
}

void BrushTool::refresh() {
  under_.reset();
  obstacle_.reset();
  if (!mouse_ || !brush_.isActive()) return;
  const BrushSettings& settings = brush_.settings();
  // The mouse's place, and points around it where the profile is a half: a stroke that meets less changes almost
  // nothing.
  constexpr std::size_t around = 8;
  std::array<std::optional<BrushPoint>, 1 + around> points;
  points[0] = under_ = canvas_.pickBrush(*mouse_, settings.mode, {});
  const double radius = settings.radius * (1.0 - 0.5 * settings.softness);
  for (std::size_t i = 0; i < around; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / around;
    points[1 + i] = canvas_.pickBrush(*mouse_ + radius * QPointF(std::cos(angle), std::sin(angle)), settings.mode, {});
  }
  obstacle_ = obstacleTo(settings, document_.look(), points);
}

QStringList BrushTool::hint() const {
  const BrushSettings& settings = brush_.settings();
  const QString name = nameOf(settings.mode);
  if (obstacle_ && !isPainting()) {
    QStringList lines{textOf(*obstacle_)};
    if (const QString remedy = remedyOf(*obstacle_); !remedy.isEmpty()) lines << Brush::tr("Space: %1").arg(remedy);
    return lines;
  }
  if (usesDepth(settings)) return {Brush::tr("%1 %2 mm").arg(name).arg(settings.depth, 0, 'f', 1)};
  if (movesRayStart(settings.mode)) return {Brush::tr("%1 to the surface").arg(name)};
  return {Brush::tr("%1 %2 %").arg(name).arg(100.0 * settings.amount, 0, 'f', 0)};
}

void BrushTool::draw(QPainter& painter, const QRectF& view) const {
  if (!brush_.isActive() || !mouse_) return;
  const BrushSettings& settings = brush_.settings();
  const QPointF at = *mouse_;
  const double radius =
      stroke_ && under_ && !stroke_->anchors.empty() ? stroke_->radius / under_->pixelSize : settings.radius;
  const bool adds = settings.mode == BrushMode::Restore || settings.mode == BrushMode::Strengthen;
  QColor colour = adds ? QColor(140, 230, 150) : QColor(255, 170, 110);
  if (!under_ || (obstacle_ && !isPainting())) colour = QColor(160, 164, 170);
  const QColor rim(0, 0, 0, 170);

  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const QPen& pen : {QPen(rim, 3.5), QPen(colour, 1.5)}) {
    painter.setPen(pen);
    painter.drawEllipse(at, radius, radius);
  }
  // Inside the dotted ring the brush has its full effect.
  const double full = radius * (1.0 - settings.softness);
  if (full >= 2.0) {
    painter.setPen(QPen(colour, 1.0, Qt::DotLine));
    painter.drawEllipse(at, full, full);
  }
  const bool deep = usesDepth(settings) && !(obstacle_ && !isPainting());
  if (deep && under_) {
    // The arrow is as long as the depth would appear from the side; up is towards the eye.
    const double length = std::clamp(settings.depth / under_->pixelSize, 3.0, 0.4 * view.height());
    const QPointF foot = at + QPointF(radius + 8.0, 0.0), head = foot + QPointF(0.0, adds ? -length : length);
    for (const QPen& pen : {QPen(rim, 4.0), QPen(colour, 2.0)}) {
      painter.setPen(pen);
      painter.drawLine(foot, head);
      painter.drawLine(foot - QPointF(3.0, 0.0), foot + QPointF(3.0, 0.0));
      const double back = adds ? 4.0 : -4.0;
      painter.drawPolyline(QPolygonF{head + QPointF(-4.0, back), head, head + QPointF(4.0, back)});
    }
  }
  const QStringList lines = hint();
  const double line = painter.fontMetrics().height();
  double width = 0.0;
  for (const QString& text : lines) width = std::max(width, painter.fontMetrics().horizontalAdvance(text) + 4.0);
  QRectF box(at.x() - 0.5 * width, at.y() + radius + 4.0, width, line * static_cast<double>(lines.size()));
  // Above the ring when the arrow points down and takes the place below.
  if ((deep && !adds) || box.bottom() > view.bottom()) box.moveBottom(at.y() - radius - 4.0);
  box.moveLeft(std::clamp(box.left(), view.left(), std::max(view.left(), view.right() - width)));
  box.setHeight(line);
  for (const QString& text : lines) {
    drawText(painter, box, Qt::AlignCenter | Qt::TextSingleLine, text, colour);
    box.translate(0.0, line);
  }
  painter.restore();
}

}  // namespace fenestra::viewer
