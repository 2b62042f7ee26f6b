// What the mouse and the keyboard do in a 3-D view.

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/gtc/constants.hpp>

#include <QHelpEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "viewer/model/ActiveTool.h"
#include "viewer/model/Brush.h"
#include "viewer/model/Document.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/StructureClick.h"
#include "viewer/model/ViewLink.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/tools/Tool.h"
#include "viewer/views/FidelityChip.h"
#include "viewer/views/RefinedPicture.h"
#include "viewer/views/ScenePreparation.h"
#include "viewer/views/VolumeView.h"

namespace fenestra::viewer {
namespace {

/// Delay before the picture is read under the mouse: a moving mouse reads nothing.
constexpr int hoverMilliseconds = 40;
constexpr double voxelsBehindSurface = 1.5;             ///< where a click without labels grows
constexpr double arrowTurn = glm::pi<double>() / 36.0;  ///< 5 degrees

}  // namespace

void VolumeView::mousePressEvent(QMouseEvent* event) {
  hover_.stop();
  shared_.pacer->lead(index_);
  if (keepsForLater(*event)) return;
  pressed_ = last_ = event->position();
  dragging_ = false;
  if (tools_.press(*event)) return;
  beforeClick_.reset();
}

void VolumeView::mouseMoveEvent(QMouseEvent* event) {
  if (brush_.isActive() && !hasFocus()) setFocus(Qt::MouseFocusReason);  // for the keys that the brush offers
  if (keepsForLater(*event)) return;
  if (!document_.hasVolume() || tools_.move(*event)) return;
  const QPointF position = event->position(), move = position - last_, total = position - pressed_;
  last_ = position;
  const Qt::MouseButtons buttons = event->buttons();
  if (buttons == Qt::NoButton) {
    setCursor(tools_.pointer(position));
    if (event->modifiers() & Qt::ShiftModifier)
      if (const std::optional<Hit> hit = pick(position)) {
        const glm::dvec3 at = surfaceAt(*hit);
        cursor_.moveTo(at);
        Q_EMIT pointed(at);
      }
    hover_.start(hoverMilliseconds);
    return;
  }
  if (!dragging_ && std::hypot(total.x(), total.y()) <= clickSlack) return;
  // The first step includes the slack, so that the picture does not lag behind the mouse.
  const QPointF step = dragging_ ? move : total;
  dragging_ = true;
  if (buttons & Qt::LeftButton && !(event->modifiers() & Qt::ShiftModifier)) {
    const double perPixel = glm::pi<double>() / std::max(1, std::min(width(), height()));
    cameras_.orbit(index_, -step.x() * perPixel, -step.y() * perPixel);
  } else if (buttons & (Qt::LeftButton | Qt::MiddleButton)) {
    const double mm = mmPerPixel(shownCamera());
    cameras_.pan(index_, -step.x() * mm, step.y() * mm);
  } else if (buttons & Qt::RightButton) {
    zoom(std::exp(-0.01 * step.y()));
  }
}

void VolumeView::mouseReleaseEvent(QMouseEvent* event) {
  if (dragging_) cameras_.release();
  if (keepsForLater(*event)) return;
  if (tools_.release(*event)) return;
  if (dragging_ || !document_.hasVolume()) return;
  const std::optional<Hit> hit = pick(event->position());
  if (!hit) return;
  if (event->button() == Qt::RightButton) {
    Q_EMIT menuRequested(surfaceAt(*hit), event->globalPosition().toPoint());
  } else if (event->button() == Qt::LeftButton) {
    click(*hit, event->modifiers());
  }
}

bool VolumeView::keepsForLater(const QMouseEvent& event) {
  const bool presses = event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonDblClick;
  const bool begins = presses && event.button() == Qt::LeftButton && !(event.modifiers() & Qt::ControlModifier);
  const bool follows = !waiting_.empty() && (event.buttons() | event.button()) & Qt::LeftButton;
  if (!active_.mode() || !picture_) return false;
  if (!follows && !((begins || tools_.isBusy()) && shared_.preparation->isBusy())) return false;
  waiting_.emplace_back(event.clone());
  repaintSurface();
  return true;
}

void VolumeView::replay() {
  // An event that is held up once more is kept again.
  for (const std::unique_ptr<QMouseEvent>& event : std::exchange(waiting_, {})) {
    if (event->type() == QEvent::MouseMove)
      mouseMoveEvent(event.get());
    else if (event->type() == QEvent::MouseButtonRelease)
      mouseReleaseEvent(event.get());
    else
      mousePressEvent(event.get());
  }
}

void VolumeView::followTools() {
  connect(&active_, &ActiveTool::changed, this, [this] {
    if (!active_.mode()) waiting_.clear();
    tools_.refresh();
    setCursor(tools_.pointer(last_));
    repaintSurface();
  });
  connect(&shared_.preparation->glContext(), &GlContext::freed, this, &VolumeView::replay);
  // A stroke was not meant for another place of the camera.
  connect(&cameras_, &ViewLink::changed, this, [this](int view) {
    if (view == index_) waiting_.clear();
  });
  connect(&cursor_, &SliceCursor::moved, this, &VolumeView::repaintSurface);
  connect(&cursor_, &SliceCursor::moved, this, &VolumeView::moveWalls);
  connect(&document_, &Document::windowChanged, this, &VolumeView::moveWalls);
}

void VolumeView::readUnderMouse() {
  if (active_.mode()) return;
  if (!isSettled()) {  // reading the picture must not hold up the next one
    hover_.start(hoverMilliseconds);
    return;
  }
  if (const std::optional<Hit> hit = pick(last_))
    Q_EMIT pointed(seenAt(*hit));
  else
    Q_EMIT left();
}

void VolumeView::click(const Hit& hit, Qt::KeyboardModifiers modifiers) {
  beforeClick_ = BeforeClick{document_.focus(), cursor_.position()};
  const glm::dvec3 seen = seenAt(hit);
  cursor_.moveTo(seen);
  Q_EMIT pointed(seen);
  // The surface's voxels hold two tissues; what is meant lies behind them.
  const glm::dvec3 behind = seen + voxelsBehindSurface * 2.0 * halfVoxel() * hit.ray;
  const bool grows = !document_.labelAt(seen) && document_.voxelAt(behind);
  clickStructure(document_, grows ? behind : seen, modifiers, options_.grows());
}

void VolumeView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (active_.mode()) {
    mousePressEvent(event);  // two quick dabs
    return;
  }
  dragging_ = true;  // so that the release that follows is no click
  if (beforeClick_) {
    if (beforeClick_->focus != document_.focus()) document_.history().takeBack();
    cursor_.moveTo(beforeClick_->cursor);
  }
  Q_EMIT maximiseRequested();
}

void VolumeView::zoom(double factor) {
  const Camera& camera = cameras_.camera(index_);
  // Between a hundredth and ten times the volume's radius, so that the camera neither passes its target nor loses
  // sight.
  const double radius = document_.scene().volume->grid.boundingRadius();
  const double distance = camera.projection == Projection::Perspective ? glm::distance(camera.eye, camera.target)
                                                                       : camera.orthographicHeight;
  cameras_.zoom(index_, distance / std::clamp(distance / factor, 0.01 * radius, 10.0 * radius));
}

void VolumeView::wheelEvent(QWheelEvent* event) {
  if (tools_.wheel(*event)) return;
  shared_.pacer->lead(index_);
  if (document_.hasVolume()) zoom(std::exp(event->angleDelta().y() * 0.0015));
}

void VolumeView::keyPressEvent(QKeyEvent* event) {
  if (tools_.key(*event)) return;
  double yaw = 0.0, pitch = 0.0;
  switch (event->key()) {
    case Qt::Key_Left:
      yaw = arrowTurn;
      break;
    case Qt::Key_Right:
      yaw = -arrowTurn;
      break;
    case Qt::Key_Up:
      pitch = arrowTurn;
      break;
    case Qt::Key_Down:
      pitch = -arrowTurn;
      break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return document_.openToRegion();
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  shared_.pacer->lead(index_);
  if (document_.hasVolume()) cameras_.orbit(index_, yaw, pitch);
}

bool VolumeView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && document_.hasVolume()) {
    const auto& help = static_cast<QHelpEvent&>(*event);
    if (showFidelity(help, *this, fidelity())) return true;
  }
  return QWidget::event(event);
}

void VolumeView::leaveEvent(QEvent*) {
  hover_.stop();
  tools_.leave();
  Q_EMIT left();
}

}  // namespace fenestra::viewer
