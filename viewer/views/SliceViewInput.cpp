// What the mouse and the keyboard do on a slice.

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QWheelEvent>

#include "viewer/model/Document.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/SlicePlanes.h"
#include "viewer/model/StructureClick.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/model/WindowDrag.h"
#include "viewer/tools/Canvas.h"
#include "viewer/tools/Tool.h"
#include "viewer/views/SliceView.h"

namespace fenestra::viewer {
namespace {

/// Device-independent pixels that the mouse may move between press and release for a click.
}  // namespace

void SliceView::mousePressEvent(QMouseEvent* event) {
  pressed_ = last_ = event->position();
  toolTookPress_ = tools_.press(*event);
  beforeClick_.reset();
  windowAtPress_ = document_.window();
  dragging_ = false;
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  if (!document_.hasVolume()) return;
  const QPointF position = event->position(), move = position - last_, total = position - pressed_;
  last_ = position;
  if (tools_.move(*event)) return;
  const Qt::MouseButtons buttons = event->buttons();
  if (buttons == Qt::NoButton) {
    setCursor(tools_.pointer(position));
    const glm::dvec3 world = worldFromWidget(position);
    if (event->modifiers() & Qt::ShiftModifier && inPicture(world)) cursor_.moveTo(world);
    if (inPicture(world))
      Q_EMIT pointed(world);
    else
      Q_EMIT left();
    return;
  }
  if (!dragging_ && std::hypot(total.x(), total.y()) <= clickSlack) return;
  dragging_ = true;
  if (buttons & Qt::LeftButton) {
    document_.setWindow(draggedWindow(windowAtPress_, total, document_.scene().volume->range));
  } else if (buttons & Qt::MiddleButton) {
    centre_ -= mmOfMove(move);
    update();
  } else if (buttons & Qt::RightButton) {
    zoomByHand(pressed_, std::exp(-0.01 * move.y()));
  }
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  if (tools_.release(*event)) return;
  if (dragging_ || !document_.hasVolume()) return;
  const glm::dvec3 world = worldFromWidget(event->position());
  if (const auto measure = measureTool_.measureAt(event->position()); measure && event->button() == Qt::RightButton) {
    Q_EMIT measureMenuRequested(*measure, event->globalPosition().toPoint());
    return;
  }
  if (event->button() == Qt::LeftButton)
    click(event->position(), event->modifiers());
  else if (event->button() == Qt::RightButton && inPicture(world))
    Q_EMIT menuRequested(world, event->globalPosition().toPoint());
}

void SliceView::click(QPointF position, Qt::KeyboardModifiers modifiers) {
  const glm::dvec3 world = worldFromWidget(position);
  if (!inPicture(world)) return;
  beforeClick_ = BeforeClick{document_.focus(), cursor_.position()};
  cursor_.moveTo(world);
  clickStructure(document_, world, modifiers, options_.grows());
  if (modifiers == Qt::NoModifier) Q_EMIT picked(world);
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !document_.hasVolume()) return;
  if (toolTookPress_) {  // such as two quick points of a measure
    mousePressEvent(event);
    return;
  }
  dragging_ = true;  // so that the release that follows is no click
  Q_EMIT pickTakenBack();
  if (beforeClick_) {
    if (beforeClick_->focus != document_.focus()) document_.history().takeBack();
    cursor_.moveTo(beforeClick_->cursor);
  }
  if (event->modifiers() & Qt::ControlModifier)
    document_.resetWindow();
  else
    Q_EMIT maximiseRequested();
}

void SliceView::zoomAt(QPointF position, double factor) {
  const QPointF fromMiddle = position - QPointF(0.5 * width(), 0.5 * height());
  const QPointF fixed = centre_ + mmOfMove(fromMiddle);
  zoom_ = std::clamp(zoom_ * factor, 0.2, 50.0);
  centre_ = fixed - mmOfMove(fromMiddle);
  update();
}

void SliceView::zoomByHand(QPointF position, double factor) {
  zoomAt(position, factor);
  Q_EMIT scaled();
}

void SliceView::wheelEvent(QWheelEvent* event) {
  if (!document_.hasVolume() || tools_.wheel(*event)) return;
  const double angle = event->angleDelta().y();
  if (event->modifiers() & Qt::ControlModifier) {
    zoomByHand(event->position(), std::exp(angle * 0.0015));
    return;
  }
  // One notch of a wheel is 120; touchpads send less at a time.
  const bool thickens = event->modifiers() & Qt::ShiftModifier;
  double& turned = thickens ? slabWheel_ : wheel_;
  // Some systems turn the wheel sideways while Shift is held.
  turned += thickens && angle == 0.0 ? event->angleDelta().x() : angle;
  const int steps = static_cast<int>(turned / 120.0);
  turned -= steps * 120.0;
  if (!steps) return;
  if (thickens)
    planes_.stepSlab(geometry_.plane, steps);
  else
    cursor_.step(geometry_, steps);
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  if (tools_.key(*event)) return;
  int steps = 0;
  switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Right:
      steps = 1;
      break;
    case Qt::Key_Down:
    case Qt::Key_Left:
      steps = -1;
      break;
    case Qt::Key_PageUp:
      steps = 10;
      break;
    case Qt::Key_PageDown:
      steps = -10;
      break;
    case Qt::Key_Home:
      steps = -geometry_.count;
      break;
    case Qt::Key_End:
      steps = geometry_.count;
      break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return document_.openToRegion();
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  if (document_.hasVolume()) cursor_.step(geometry_, steps);
}

void SliceView::leaveEvent(QEvent*) {
  tools_.leave();
  Q_EMIT left();
}

class SliceView::ToolCanvas : public SliceCanvas {
 public:
  explicit ToolCanvas(SliceView& view) : view_(view) {}

  const SliceGeometry& geometry() const override { return view_.geometry_; }
  int slice() const override { return view_.slice_; }
  QRectF view() const override { return view_.rect(); }
  glm::dvec3 right() const override { return view_.screenRight(); }
  glm::dvec3 down() const override { return view_.screenDown(); }
  QPointF onSlice(glm::dvec3 world) const override { return view_.widgetFromWorld(world); }
  glm::dvec3 worldFromWidget(QPointF position) const override { return view_.worldFromWidget(position); }
  std::optional<glm::dvec3> pickSurface(QPointF position) const override {
    if (!view_.document_.hasVolume()) return std::nullopt;
    const glm::dvec3 world = worldFromWidget(position);
    return view_.inPicture(world) ? std::optional(world) : std::nullopt;
  }
  void redraw() const override { view_.update(); }

 private:
  SliceView& view_;
};

std::unique_ptr<SliceCanvas> SliceView::makeCanvas() { return std::make_unique<ToolCanvas>(*this); }

}  // namespace fenestra::viewer
