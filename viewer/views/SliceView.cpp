#include "viewer/views/SliceView.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "viewer/model/Document.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/StructureClick.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/style/InterpolatedPlanes.h"
#include "viewer/style/Overlay.h"

namespace fenestra::viewer {
namespace {

/// Device-independent pixels that the mouse may move between press and release for a click.
constexpr double clickSlack = 4.0;
/// Share of the label's colour in a tinted pixel.
constexpr int tintPercent = 25, focusTintPercent = 45;

QRgb blend(int grey, glm::dvec3 colour, int percent) {
  const auto channel = [&](double value) {
    return (grey * (100 - percent) + static_cast<int>(255.0 * value) * percent) / 100;
  };
  return qRgb(channel(colour.r), channel(colour.g), channel(colour.b));
}

}  // namespace

SliceView::SliceView(SlicePlane plane, Document& document, SliceCursor& cursor, ViewOptions& options, QWidget* parent)
    : QWidget(parent), document_(document), cursor_(cursor), options_(options), toleranceWheel_(document) {
  geometry_.plane = plane;
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setObjectName(QStringLiteral("slice%1").arg(static_cast<int>(plane)));

  connect(&document, &Document::volumeChanged, this, &SliceView::readGeometry);
  connect(&document, &Document::windowChanged, this, &SliceView::invalidate);
  connect(&document, &Document::focusChanged, this, &SliceView::invalidate);
  connect(&document, &Document::labelSettingsChanged, this, &SliceView::invalidate);
  connect(&document, &Document::labelsChanged, this, [this] {
    labels_.clear();
    invalidate();
  });
  connect(&options, &ViewOptions::changed, this, &SliceView::invalidate);
  connect(&cursor, &SliceCursor::moved, this, &SliceView::followCursor);
  readGeometry();
}

void SliceView::readGeometry() {
  if (!document_.hasVolume()) return;
  geometry_ = fenestra::sliceGeometry(document_.scene().volume->grid, geometry_.plane);
  zoom_ = 1.0;
  centre_ = {0.5 * geometry_.width * glm::length(geometry_.right),
             0.5 * geometry_.height * glm::length(geometry_.down)};
  slice_ = cursor_.slice(geometry_);
  values_.clear();
  labels_.clear();
  steps_.clear();
  invalidate();
}

void SliceView::followCursor() {
  const int slice = cursor_.slice(geometry_);
  if (slice != slice_) {
    slice_ = slice;
    values_.clear();
    labels_.clear();
    steps_.clear();
    image_ = {};
  }
  update();
}

void SliceView::invalidate() {
  image_ = {};
  update();
}

void SliceView::resetView() {
  readGeometry();
  document_.resetWindow();
}

/// The look of each label, found once a label rather than once a pixel.
class SliceView::Tints {
 public:
  struct Tint {
    glm::dvec3 colour{0.0};
    int percent = 0;
    bool focused = false;
  };

  Tints(const Document& document, const SliceView& view) : view_(view) {
    const Scene& scene = document.scene();
    if (const auto* values = std::get_if<ValueFocus>(&scene.look.focus)) values_ = values->values;
    focus_ = {document.region() ? segmentation::regionColour : scene.look.focusAppearance.colour, focusTintPercent,
              true};
    if (!view.steps_.empty()) lastStep_ = static_cast<std::uint16_t>(document.regionStep());
    if (view.labels_.empty()) return;
    labels_.resize(std::size_t{1} + *std::max_element(view.labels_.begin(), view.labels_.end()));
    for (const Label& label : document.labels()->labels) {
      if (label.value >= labels_.size() || label.value == 0) continue;
      const LabelSetting setting = document.labelSetting(label.value);
      if (!setting.visible) continue;
      const bool focused = document.isFocused(label.value);
      const double percent = setting.opacity * (focused ? focusTintPercent : tintPercent);
      labels_[label.value] = {document.colourOf(label), static_cast<int>(std::lround(percent)), focused};
    }
  }

  const Tint& at(std::size_t pixel) const {
    static const Tint none;
    const float value = view_.values_[pixel];
    if (values_ && value >= values_->low && value <= values_->high) return focus_;
    // 0, no step, lies beyond all others then.
    if (!view_.steps_.empty() && static_cast<std::uint16_t>(view_.steps_[pixel] - 1) < lastStep_) return focus_;
    return labels_.empty() ? none : labels_[view_.labels_[pixel]];
  }

 private:
  const SliceView& view_;
  std::vector<Tint> labels_;
  Tint focus_;
  std::optional<ValueRange> values_;
  std::uint16_t lastStep_ = 0;
};

void SliceView::makeImage() {
  const Volume& volume = *document_.scene().volume;
  if (values_.empty()) values_ = sliceValues(volume, geometry_, slice_);
  if (labels_.empty() && document_.labels()) labels_ = sliceLabels(*document_.labels(), geometry_, slice_);
  const std::shared_ptr<const LabelMap> steps = document_.growth() ? document_.growth()->steps : nullptr;
  if (std::exchange(stepsOf_, steps) != steps) steps_.clear();
  if (steps && steps_.empty()) steps_ = sliceLabels(*steps, geometry_, slice_);
  const std::vector<std::uint8_t> grey = windowed(values_, document_.window(), volume.lowIsWhite);

  const Tints tints(document_, *this);
  std::vector<char> focused(values_.size(), 0);
  image_ = QImage(geometry_.width, geometry_.height, QImage::Format_RGB32);
  for (int row = 0; row < geometry_.height; ++row) {
    auto* line = reinterpret_cast<QRgb*>(image_.scanLine(row));
    for (int column = 0; column < geometry_.width; ++column) {
      const std::size_t at =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(geometry_.width) + static_cast<std::size_t>(column);
      const Tints::Tint& tint = tints.at(at);
      focused[at] = tint.focused;
      line[column] = options_.labels() && tint.percent ? blend(grey[at], tint.colour, tint.percent)
                                                       : qRgb(grey[at], grey[at], grey[at]);
    }
  }
  collectOutline(focused);
}

void SliceView::collectOutline(const std::vector<char>& focused) {
  outline_.clear();
  if (!options_.labels()) return;
  const auto in = [&](int column, int row) {
    return column >= 0 && row >= 0 && column < geometry_.width && row < geometry_.height &&
           focused[static_cast<std::size_t>(row) * static_cast<std::size_t>(geometry_.width) +
                   static_cast<std::size_t>(column)];
  };
  for (int row = 0; row <= geometry_.height; ++row)
    for (int column = 0; column <= geometry_.width; ++column) {
      if (in(column, row) != in(column - 1, row)) outline_.append({QPointF(column, row), QPointF(column, row + 1)});
      if (in(column, row) != in(column, row - 1)) outline_.append({QPointF(column, row), QPointF(column + 1, row)});
    }
}

double SliceView::pixelsPerMm() const {
  const double fit = std::min(width() / (geometry_.width * glm::length(geometry_.right)),
                              height() / (geometry_.height * glm::length(geometry_.down)));
  return fit * zoom_;
}

QPointF SliceView::widgetFromWorld(glm::dvec3 world) const {
  const glm::dvec3 pixel = geometry_.pixelFromWorld(world);
  const QPointF mm((pixel.x + 0.5) * glm::length(geometry_.right), (pixel.y + 0.5) * glm::length(geometry_.down));
  return QPointF(0.5 * width(), 0.5 * height()) + (mm - centre_) * pixelsPerMm();
}

glm::dvec3 SliceView::worldFromWidget(QPointF position) const {
  const QPointF mm = centre_ + (position - QPointF(0.5 * width(), 0.5 * height())) / pixelsPerMm();
  return geometry_.worldFromPixel(mm.x() / glm::length(geometry_.right) - 0.5,
                                  mm.y() / glm::length(geometry_.down) - 0.5, slice_);
}

bool SliceView::inPicture(glm::dvec3 world) const {
  const glm::dvec3 pixel = geometry_.pixelFromWorld(world);
  return pixel.x >= -0.5 && pixel.y >= -0.5 && pixel.x < geometry_.width - 0.5 && pixel.y < geometry_.height - 0.5;
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (!document_.hasVolume()) return;
  if (image_.isNull()) makeImage();

  const double scale = pixelsPerMm();
  const QPointF topLeft = QPointF(0.5 * width(), 0.5 * height()) - centre_ * scale;
  const QRectF target(topLeft, QSizeF(geometry_.width * glm::length(geometry_.right) * scale,
                                      geometry_.height * glm::length(geometry_.down) * scale));
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(target, image_);

  if (!outline_.isEmpty()) {
    painter.save();
    painter.translate(topLeft);
    painter.scale(target.width() / geometry_.width, target.height() / geometry_.height);
    QPen pen(QColor(255, 240, 190), 1.2);
    pen.setCosmetic(true);
    painter.setPen(pen);
    painter.drawLines(outline_);
    painter.restore();
  }
  if (options_.labels()) drawSeeds(painter);
  const bool interpolated = drawInterpolated(painter, target);
  if (options_.crosshair()) drawCrosshair(painter);

  const QRectF view = rect();
  drawEdgeLetters(painter, view, geometry_.right, geometry_.down);
  drawScaleBar(painter, view, 1.0 / scale);
  QStringList title{planeName(geometry_.plane)};
  if (interpolated) title << tr("Interpolated, not scanned");
  if (options_.text()) {
    title << tr("%1 / %2").arg(slice_ + 1).arg(geometry_.count);
    const WindowLevel window = document_.window();
    const int decimals = window.width < 10.0 ? 2 : 0;
    drawCorner(painter, view, Qt::AlignBottom | Qt::AlignLeft,
               {tr("W %1  L %2").arg(window.width, 0, 'f', decimals).arg(window.level, 0, 'f', decimals)},
               QColor(190, 194, 200));
    if (geometry_.plane != SlicePlane::Sagittal)  // where left and right could be mistaken
      drawCorner(painter, view, Qt::AlignTop | Qt::AlignRight, {tr("Radiological")}, QColor(150, 154, 160));
  }
  drawCorner(painter, view, Qt::AlignTop | Qt::AlignLeft, title, planeColour(geometry_.plane));
  if (hasFocus()) {
    painter.setPen(QColor(86, 140, 190));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

bool SliceView::drawInterpolated(QPainter& painter, const QRectF& picture) const {
  const std::optional<io::GeometryReport>& report = document_.study().geometry;
  if (!report || report->interpolatedPlanes.empty()) return false;
  const Grid& grid = document_.scene().volume->grid;
  QTransform widgetFromPixel = QTransform::fromTranslate(picture.left(), picture.top());
  widgetFromPixel.scale(picture.width() / geometry_.width, picture.height() / geometry_.height);
  drawInterpolatedBands(painter, interpolatedBands(report->interpolatedPlanes, grid, geometry_, slice_),
                        widgetFromPixel);
  return isInterpolated(report->interpolatedPlanes, grid, geometry_, slice_);
}

void SliceView::drawCrosshair(QPainter& painter) const {
  const QPointF at = widgetFromWorld(cursor_.position());
  // Each line is where another plane cuts this one, in that plane's colour.
  const SlicePlane vertical = geometry_.plane == SlicePlane::Sagittal ? SlicePlane::Coronal : SlicePlane::Sagittal;
  const SlicePlane horizontal = geometry_.plane == SlicePlane::Axial ? SlicePlane::Coronal : SlicePlane::Axial;
  constexpr double gap = 10.0;  // around the crossing, so that the lines do not cover the voxel
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  const auto line = [&](SlicePlane plane, QPointF from, QPointF to) {
    QColor colour = planeColour(plane);
    colour.setAlpha(170);
    painter.setPen(QPen(colour, 1));
    painter.drawLine(from, to);
  };
  line(vertical, {at.x(), 0.0}, {at.x(), at.y() - gap});
  line(vertical, {at.x(), at.y() + gap}, {at.x(), static_cast<double>(height())});
  line(horizontal, {0.0, at.y()}, {at.x() - gap, at.y()});
  line(horizontal, {at.x() + gap, at.y()}, {static_cast<double>(width()), at.y()});
  painter.restore();
}

void SliceView::drawSeeds(QPainter& painter) const {
  const RegionFocus* region = document_.region();
  if (!region) return;
  const auto draw = [&](const std::vector<glm::dvec3>& seeds, bool inside) {
    for (const glm::dvec3 seed : seeds)
      if (std::lround(geometry_.pixelFromWorld(seed).z) == slice_) drawSeed(painter, widgetFromWorld(seed), inside);
  };
  draw(region->inside, true);
  draw(region->outside, false);
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  pressed_ = last_ = event->position();
  beforeClick_.reset();
  windowAtPress_ = document_.window();
  dragging_ = false;
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  if (!document_.hasVolume()) return;
  const QPointF position = event->position(), move = position - last_, total = position - pressed_;
  last_ = position;
  const Qt::MouseButtons buttons = event->buttons();
  if (buttons == Qt::NoButton) {
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
    // A drag over 250 pixels doubles the width. A very narrow window changes faster, or it could not be widened.
    const ValueRange range = document_.scene().volume->range;
    const double perPixel = std::max(windowAtPress_.width, 0.02 * (range.high - range.low)) / 250.0;
    const double least = std::max(1e-4 * (range.high - range.low), 1e-9);
    document_.setWindow(
        {std::max(windowAtPress_.width + total.x() * perPixel, least), windowAtPress_.level + total.y() * perPixel});
  } else if (buttons & Qt::MiddleButton) {
    centre_ -= move / pixelsPerMm();
    update();
  } else if (buttons & Qt::RightButton) {
    zoomAt(pressed_, std::exp(-0.01 * move.y()));
  }
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  if (dragging_ || !document_.hasVolume()) return;
  const glm::dvec3 world = worldFromWidget(event->position());
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
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !document_.hasVolume()) return;
  dragging_ = true;  // so that the release that follows is no click
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
  const QPointF fixed = centre_ + fromMiddle / pixelsPerMm();
  zoom_ = std::clamp(zoom_ * factor, 0.2, 50.0);
  centre_ = fixed - fromMiddle / pixelsPerMm();
  update();
}

void SliceView::wheelEvent(QWheelEvent* event) {
  if (!document_.hasVolume() || toleranceWheel_.wheel(*event)) return;
  const double angle = event->angleDelta().y();
  if (event->modifiers() & Qt::ControlModifier) {
    zoomAt(event->position(), std::exp(angle * 0.0015));
    return;
  }
  // One notch of a wheel is 120; touchpads send less at a time.
  wheel_ += angle;
  const int steps = static_cast<int>(wheel_ / 120.0);
  wheel_ -= steps * 120.0;
  if (steps) cursor_.step(geometry_, steps);
}

void SliceView::keyPressEvent(QKeyEvent* event) {
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
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  if (document_.hasVolume()) cursor_.step(geometry_, steps);
}

void SliceView::leaveEvent(QEvent*) { Q_EMIT left(); }

}  // namespace fenestra::viewer
