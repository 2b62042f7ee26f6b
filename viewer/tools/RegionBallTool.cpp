#include "viewer/tools/RegionBallTool.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QMouseEvent>

#include "viewer/model/Workspace.h"
#include "viewer/style/Overlay.h"
#include "viewer/tools/Canvas.h"

namespace fenestra::viewer {
namespace {

/// Device-independent pixels that the mouse may move between press and release for a click.
const QColor ringColour(242, 184, 77);

}  // namespace

RegionBallTool::RegionBallTool(Workspace& workspace, Canvas& canvas) : workspace_(workspace), canvas_(canvas) {}

bool RegionBallTool::press(const QMouseEvent& event) {
  drags_ = false;
  centre_.reset();
  if (event.modifiers() != Qt::ShiftModifier || !workspace_.options.grows() || workspace_.tool.mode() ||
      !workspace_.document.hasVolume())
    return false;
  centre_ = canvas_.pickStructure(event.position());
  if (centre_ && !workspace_.document.voxelAt(*centre_)) centre_.reset();
  pressed_ = event.position();
  return centre_.has_value();
}

void RegionBallTool::drag(const QMouseEvent& event) {
  const QPointF moved = event.position() - pressed_;
  const double pixels = std::hypot(moved.x(), moved.y()), perMm = canvas_.pixelsOf(1.0, *centre_);
  drags_ = drags_ || pixels > clickSlack;
  if (drags_ && perMm > 0.0) workspace_.ball.set(RegionBall::Ball{*centre_, pixels / perMm});
}

void RegionBallTool::release(const QMouseEvent& event) {
  drag(event);
  const std::optional<RegionBall::Ball> drawn = workspace_.ball.ball();
  leave();
  if (!drawn) return;
  workspace_.cursor.moveTo(drawn->centre);
  workspace_.document.growFrom(drawn->centre, drawn->radius);
}

void RegionBallTool::leave() {
  if (centre_) workspace_.ball.set(std::nullopt);
  centre_.reset();
}

void RegionBallTool::draw(QPainter& painter, const QRectF&) const {
  const std::optional<RegionBall::Ball>& drawn = workspace_.ball.ball();
  const RegionFocus* region = workspace_.document.region();
  const auto section = canvas_.section();
  // The ball of a region that is there shows on slices, beside its seed.
  const bool bounds = section && workspace_.options.labels() && region && region->ball > 0.0 && !region->inside.empty();
  if (!drawn && !bounds) return;
  const RegionBall::Ball ball = drawn ? *drawn : RegionBall::Ball{region->inside.front(), region->ball};
  const std::optional<QPointF> middle = canvas_.widgetFromWorld(ball.centre);
  if (!middle) return;
  const double away = section ? glm::dot(ball.centre - section->point, section->normal) : 0.0;
  const double radius = std::sqrt(std::max(0.0, ball.radius * ball.radius - away * away));
  const double pixels = canvas_.pixelsOf(radius, ball.centre);
  if (pixels <= 0.0) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const QPen& pen : {QPen(QColor(0, 0, 0, 170), drawn ? 3.5 : 2.4),
                          QPen(ringColour, drawn ? 1.5 : 1.0, drawn ? Qt::SolidLine : Qt::DotLine)}) {
    painter.setPen(pen);
    painter.drawEllipse(*middle, pixels, pixels);
  }
  painter.restore();
  if (drawn)
    drawText(painter, QRectF(*middle + QPointF(0.0, -pixels - 24.0), QSizeF()).adjusted(-80.0, 0.0, 80.0, 20.0),
             Qt::AlignCenter | Qt::TextSingleLine,
             QCoreApplication::translate("RegionBall", "%1 mm").arg(ball.radius, 0, 'f', 1), ringColour);
}

}  // namespace fenestra::viewer
