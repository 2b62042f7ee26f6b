#include "viewer/panels/ReformatPicture.h"

#include <cmath>
#include <utility>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "rendering/volume/Slice.h"
#include "viewer/model/Document.h"
#include "viewer/model/WindowDrag.h"

namespace fenestra::viewer {
namespace {

constexpr double reformatClickSlack = 4.0;  ///< device-independent pixels that a click may move
const QColor placeColour(255, 140, 90);     ///< of the path in all views

}  // namespace

ReformatPicture::ReformatPicture(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  connect(&document, &Document::windowChanged, this, [this] {
    image_ = {};
    update();
  });
}

void ReformatPicture::setPixels(Pixels pixels) {
  pixels_ = std::move(pixels);
  image_ = {};
  update();
}

void ReformatPicture::setLine(std::optional<double> row) {
  line_ = row;
  update();
}

QRectF ReformatPicture::shownIn() const {
  if (pixels_.values.empty()) return {};
  const QSizeF size = QSizeF(pixels_.width, pixels_.height).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
  return {QPointF(0.5 * (width() - size.width()), 0.5 * (height() - size.height())), size};
}

void ReformatPicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  const QRectF shown = shownIn();
  if (!shown.isEmpty()) {
    if (image_.isNull()) {
      const bool lowIsWhite = document_.scene().volume && document_.scene().volume->lowIsWhite;
      const std::vector<std::uint8_t> grey =
          windowed(pixels_.values, document_.window(), lowIsWhite != document_.isInverted());
      image_ = QImage(grey.data(), pixels_.width, pixels_.height, pixels_.width, QImage::Format_Grayscale8).copy();
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawImage(shown, image_);
    painter.setPen(QPen(placeColour, 1.4));
    if (line_) {
      const double y = shown.top() + *line_ * shown.height() / pixels_.height;
      // Open in the middle, where the structure is.
      const double gap = 0.25 * shown.width();
      painter.drawLine(QPointF(shown.left(), y), QPointF(shown.center().x() - gap, y));
      painter.drawLine(QPointF(shown.center().x() + gap, y), QPointF(shown.right(), y));
    } else {
      constexpr double arm = 5.0;
      painter.drawLine(shown.center() - QPointF(arm, 0.0), shown.center() + QPointF(arm, 0.0));
      painter.drawLine(shown.center() - QPointF(0.0, arm), shown.center() + QPointF(0.0, arm));
    }
  }
  if (!hasFocus()) return;
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QColor(86, 140, 190));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void ReformatPicture::choose(QPointF position) {
  const QRectF shown = shownIn();
  if (!line_ || !shown.contains(position)) return;
  Q_EMIT chosen(((position.y() - shown.top()) / shown.height() * pixels_.height - 0.5) * pixels_.spacing);
}

void ReformatPicture::mousePressEvent(QMouseEvent* event) {
  pressed_ = event->position();
  windowAtPress_ = document_.window();
  dragging_ = event->button() != Qt::LeftButton;
}

void ReformatPicture::mouseMoveEvent(QMouseEvent* event) {
  if (!document_.hasVolume() || pixels_.values.empty()) return;
  if (event->buttons() == Qt::NoButton && event->modifiers() & Qt::ShiftModifier) return choose(event->position());
  if (!(event->buttons() & Qt::LeftButton)) return;
  const QPointF total = event->position() - pressed_;
  if (!dragging_ && std::hypot(total.x(), total.y()) <= reformatClickSlack) return;
  dragging_ = true;
  document_.setWindow(draggedWindow(windowAtPress_, total, document_.scene().volume->range));
}

void ReformatPicture::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !dragging_) choose(event->position());
}

void ReformatPicture::wheelEvent(QWheelEvent* event) {
  wheel_ += event->angleDelta().y();
  const int steps = static_cast<int>(wheel_ / 120.0);
  wheel_ -= steps * 120.0;
  if (steps) Q_EMIT stepped(-steps);  // the path runs down
  event->accept();
}

void ReformatPicture::keyPressEvent(QKeyEvent* event) {
  constexpr int all = 1 << 20;
  switch (event->key()) {
    case Qt::Key_Down:
    case Qt::Key_Right:
      return Q_EMIT stepped(1);
    case Qt::Key_Up:
    case Qt::Key_Left:
      return Q_EMIT stepped(-1);
    case Qt::Key_PageDown:
      return Q_EMIT stepped(10);
    case Qt::Key_PageUp:
      return Q_EMIT stepped(-10);
    case Qt::Key_Home:
      return Q_EMIT stepped(-all);
    case Qt::Key_End:
      return Q_EMIT stepped(all);
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace fenestra::viewer
