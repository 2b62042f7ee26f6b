// Where a slice's pixels lie in its view: zoomed, moved, mirrored and turned.

#include <algorithm>
#include <cmath>

#include <QScreen>

#include "viewer/model/Document.h"
#include "viewer/model/SlicePlanes.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/views/SliceView.h"

namespace fenestra::viewer {

SliceView::Turn SliceView::turn() const {
  Turn turn = turn_;
  // The convention mirrors the slice itself, before it is turned. Sagittal slices have no left and right, and a slice
  // that follows a camera shows what the camera does.
  const bool follows = planes_.pose(geometry_.plane).follow != PlaneFollow::None;
  if (options_.isNeurological() && geometry_.plane != SlicePlane::Sagittal && !follows) turn.mirrored = !turn.mirrored;
  return turn;
}

void SliceView::setTurn(Turn turn) {
  turn_ = turn;
  update();
}

// A flip of the screen goes before the turn as one across the slice after the opposite turn.
void SliceView::flipAcross() { setTurn({!turn_.mirrored, (4 - turn_.quarters) % 4}); }

void SliceView::flipDown() { setTurn({!turn_.mirrored, (6 - turn_.quarters) % 4}); }

void SliceView::turnClockwise() { setTurn({turn_.mirrored, (turn_.quarters + 1) % 4}); }

QTransform SliceView::widgetFromMm() const {
  const Turn turn = this->turn();
  const double scale = pixelsPerMm();
  QTransform transform = QTransform::fromTranslate(0.5 * width(), 0.5 * height());
  transform.rotate(90.0 * turn.quarters);
  transform.scale(turn.mirrored ? -scale : scale, scale);
  transform.translate(-centre_.x(), -centre_.y());
  return transform;
}

QTransform SliceView::widgetFromPixels() const {
  QTransform transform = widgetFromMm();
  transform.translate(picture_.corner.x(), picture_.corner.y());
  transform.scale(glm::length(picture_.geometry.right), glm::length(picture_.geometry.down));
  return transform;
}

QPointF SliceView::mmOfMove(QPointF move) const {
  const Turn turn = this->turn();
  QTransform sliceFromWidget;
  sliceFromWidget.scale(turn.mirrored ? -1.0 : 1.0, 1.0);
  sliceFromWidget.rotate(-90.0 * turn.quarters);
  return sliceFromWidget.map(move) / pixelsPerMm();
}

glm::dvec3 SliceView::screenRight() const {
  const Turn turn = this->turn();
  const glm::dvec3 right = turn.mirrored ? -geometry_.right : geometry_.right;
  const glm::dvec3 along[] = {right, -geometry_.down, -right, geometry_.down};
  return along[turn.quarters];
}

glm::dvec3 SliceView::screenDown() const {
  const Turn turn = this->turn();
  const glm::dvec3 right = turn.mirrored ? -geometry_.right : geometry_.right;
  const glm::dvec3 along[] = {geometry_.down, right, -geometry_.down, -right};
  return along[turn.quarters];
}

double SliceView::pixelsPerMm() const {
  const QSizeF view = sizeAlongSlice();
  return std::min(view.width() / fitted_.width(), view.height() / fitted_.height()) * zoom_;
}

QSizeF SliceView::sizeAlongSlice() const {
  const QSizeF size(width(), height());
  return turn_.quarters % 2 != 0 ? size.transposed() : size;
}

double SliceView::screenPixelsPerMm() const {
  // A screen that does not say its size, such as a virtual one, may say 0 or less than a telephone has.
  constexpr double leastWidth = 40.0;  // mm
  const QScreen* at = screen();
  if (!at || at->physicalSize().width() < leastWidth) return 0.0;
  return at->geometry().width() / at->physicalSize().width();
}

bool SliceView::showTrueSize() {
  const double wanted = screenPixelsPerMm();
  if (!(wanted > 0.0) || !document_.hasVolume()) return false;
  zoom_ *= wanted / pixelsPerMm();
  update();
  Q_EMIT scaled();
  return true;
}

void SliceView::setScale(double wanted) {
  if (!document_.hasVolume() || !(wanted > 0.0) || !(pixelsPerMm() > 0.0)) return;
  zoomAt(widgetFromWorld(cursor_.position()), wanted / pixelsPerMm());
}

bool SliceView::isTrueSize() const {
  const double wanted = screenPixelsPerMm();
  constexpr double rounding = 1e-6;
  return wanted > 0.0 && std::abs(pixelsPerMm() / wanted - 1.0) < rounding;
}

QPointF SliceView::widgetFromWorld(glm::dvec3 world) const {
  const glm::dvec3 pixel = geometry_.pixelFromWorld(world);
  return widgetFromMm().map(
      QPointF((pixel.x + 0.5) * glm::length(geometry_.right), (pixel.y + 0.5) * glm::length(geometry_.down)));
}

glm::dvec3 SliceView::worldFromWidget(QPointF position) const {
  const QPointF mm = centre_ + mmOfMove(position - QPointF(0.5 * width(), 0.5 * height()));
  return geometry_.worldFromPixel(mm.x() / glm::length(geometry_.right) - 0.5,
                                  mm.y() / glm::length(geometry_.down) - 0.5, slice_);
}

}  // namespace fenestra::viewer
