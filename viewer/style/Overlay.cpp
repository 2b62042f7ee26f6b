#include "viewer/style/Overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainterPath>
#include <QPixmapCache>
#include <QPolygonF>
#include <QTransform>

namespace fenestra::viewer {
namespace {

const QColor rim(0, 0, 0, 230);
constexpr double haloWidth = 1.75;  ///< device-independent pixels around the strokes of a letter

/// The largest of 1, 2, 5 × 10ⁿ that does not exceed `limit`.
double roundLength(double limit) {
  const double decade = std::pow(10.0, std::floor(std::log10(limit)));
  for (double step : {5.0, 2.0})
    if (step * decade <= limit) return step * decade;
  return decade;
}

/// One line of text with its halo, as wide as its advance and as high as its font, with a margin of `haloMargin`. It is
/// painted into a pixmap first: OpenGL's painter smooths no outlines, and the views repaint the same texts often.
constexpr double haloMargin = 3.0;
QPixmap haloedText(const QString& text, const QFont& font, const QColor& colour, double ratio) {
  const QString key =
      QStringLiteral("halo|%1|%2|%3|%4").arg(font.key(), colour.name(QColor::HexArgb)).arg(ratio).arg(text);
  QPixmap made;
  if (QPixmapCache::find(key, &made)) return made;
  const QFontMetricsF metrics(font);
  const QSizeF size(metrics.horizontalAdvance(text) + 2.0 * haloMargin, metrics.height() + 2.0 * haloMargin);
  made = QPixmap((size * ratio).toSize() + QSize(1, 1));
  made.setDevicePixelRatio(ratio);
  made.fill(Qt::transparent);
  QPainter painter(&made);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font);
  const QPointF baseline(haloMargin, haloMargin + metrics.ascent());
  QPainterPath letters;
  letters.addText(baseline, painter.font(), text);
  painter.strokePath(letters, QPen(rim, 2.0 * haloWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setPen(colour);
  painter.drawText(baseline, text);
  painter.end();
  QPixmapCache::insert(key, made);
  return made;
}

/// A text in lines no wider than `width`, broken between words; a wider word has a line of its own.
QStringList wrapped(const QString& text, const QFontMetricsF& metrics, double width) {
  if (metrics.horizontalAdvance(text) <= width) return {text};
  QStringList lines;
  for (const QString& word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
    const QString longer = lines.isEmpty() ? QString() : lines.back() + QLatin1Char(' ') + word;
    if (!longer.isEmpty() && metrics.horizontalAdvance(longer) <= width)
      lines.back() = longer;
    else
      lines << word;
  }
  return lines;
}

/// How wide a text in a corner may be beside the letter in the middle of the edge: two bold letters at most, half of
/// them on either side.
double besideLetter(const QRectF& view, const QFontMetricsF& metrics) {
  return 0.5 * view.width() - overlayMargin - metrics.horizontalAdvance(QStringLiteral("WW"));
}

}  // namespace

QColor toColour(glm::dvec3 rgb) {
  rgb = glm::clamp(rgb, 0.0, 1.0);
  return QColor::fromRgbF(static_cast<float>(rgb.r), static_cast<float>(rgb.g), static_cast<float>(rgb.b));
}

glm::dvec3 fromColour(const QColor& colour) { return {colour.redF(), colour.greenF(), colour.blueF()}; }

QColor planeColour(SlicePlane plane) {
  switch (plane) {
    case SlicePlane::Axial:
      return {240, 110, 100};
    case SlicePlane::Sagittal:
      return {235, 200, 90};
    case SlicePlane::Coronal:
      break;
  }
  return {120, 205, 125};
}

QString planeName(SlicePlane plane) {
  switch (plane) {
    case SlicePlane::Axial:
      return QCoreApplication::translate("Overlay", "Axial");
    case SlicePlane::Sagittal:
      return QCoreApplication::translate("Overlay", "Sagittal");
    case SlicePlane::Coronal:
      break;
  }
  return QCoreApplication::translate("Overlay", "Coronal");
}

QSizeF textSize(const QPainter& painter, const QString& text) {
  const QFontMetricsF metrics(painter.font());
  return {metrics.horizontalAdvance(text), metrics.height()};
}

void drawText(QPainter& painter, const QRectF& box, int alignment, const QString& text, const QColor& colour) {
  if (text.isEmpty()) return;
  const QSizeF size = textSize(painter, text);
  QPointF at = box.topLeft();
  if (alignment & Qt::AlignRight) at.setX(box.right() - size.width());
  if (alignment & Qt::AlignHCenter) at.setX(box.center().x() - 0.5 * size.width());
  if (alignment & Qt::AlignBottom) at.setY(box.bottom() - size.height());
  if (alignment & Qt::AlignVCenter) at.setY(box.center().y() - 0.5 * size.height());
  // Letters stay sharp only on whole pixels of the device. The painter of a saved picture is scaled, so it has more
  // pixels than its device's ratio says.
  const QTransform toDevice = painter.deviceTransform();
  const QPointF corner = toDevice.map(at - QPointF(haloMargin, haloMargin));
  painter.drawPixmap(toDevice.inverted().map(QPointF(std::round(corner.x()), std::round(corner.y()))),
                     haloedText(text, painter.font(), colour, toDevice.m11()));
}

bool fitsBesideLetter(const QPainter& painter, const QRectF& view, const QString& text) {
  const QFontMetricsF metrics(painter.font());
  return metrics.horizontalAdvance(text) <= besideLetter(view, metrics);
}

void drawCorner(QPainter& painter, const QRectF& view, Qt::Alignment corner, const QStringList& lines,
                const QColor& colour) {
  const QFontMetricsF metrics(painter.font());
  const double height = painter.fontMetrics().lineSpacing(), half = 0.5 * view.width() - overlayMargin;
  QStringList shown;
  qsizetype titleLines = 0;
  for (const QString& text : lines) {
    shown += wrapped(text, metrics, half);
    if (titleLines == 0) titleLines = shown.size();
  }
  const bool top = !(corner & Qt::AlignBottom);
  QRectF line = view.adjusted(overlayMargin, overlayMargin, -overlayMargin, -overlayMargin);
  if (!top) line.setTop(line.bottom() - height * static_cast<double>(shown.size()));
  if (!shown.isEmpty() && !fitsBesideLetter(painter, view, top ? shown.front() : shown.back()))
    line.translate(0, top ? height : -height);
  const double width = line.width();
  line.setHeight(height);
  const int alignment = static_cast<int>((corner & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter);
  for (qsizetype i = 0; i < shown.size(); ++i) {
    drawText(painter, line, alignment, metrics.elidedText(shown[i], Qt::ElideRight, width),
             i < titleLines ? colour : overlayGrey);
    line.translate(0, height);
  }
}

QRectF chipIn(const QRectF& view) {
  return {view.left() + overlayMargin, view.top() + overlayMargin + 1.0, 15.0, 15.0};
}

void drawChip(QPainter& painter, const QRectF& view, const QColor& colour, const QString& symbol) {
  const QRectF chip = chipIn(view);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(rim, 1.0));
  painter.setBrush(colour);
  painter.drawRoundedRect(chip, 4.0, 4.0);
  QFont font = painter.font();
  font.setBold(true);
  font.setPixelSize(13);
  painter.setFont(font);
  painter.setPen(QColor(16, 18, 22));
  painter.drawText(chip, Qt::AlignCenter, symbol);
  painter.restore();
}

QRectF besideChip(const QRectF& view) { return view.adjusted(chipRoom, 0.0, -chipRoom, 0.0); }

void drawWaiting(QPainter& painter, const QRectF& view, const QString& text) {
  const QFontMetricsF metrics(painter.font());
  const QString shown = metrics.elidedText(text, Qt::ElideRight, view.width() - 6.0 * overlayMargin);
  const QSizeF size(metrics.horizontalAdvance(shown) + 4.0 * overlayMargin, metrics.height() + overlayMargin);
  const QRectF plate(
      QPointF(view.center().x() - 0.5 * size.width(), view.bottom() - 5.0 * overlayMargin - size.height()), size);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(60, 44, 8, 225));
  painter.drawRoundedRect(plate, 5.0, 5.0);
  painter.setPen(QColor(255, 214, 130));
  painter.drawText(plate, Qt::AlignCenter, shown);
  painter.restore();
}

void drawStudyText(QPainter& painter, const QRectF& view, const QStringList& lines, int above) {
  // Below the upper quarter of a small view, text would cover what the view is for. Who it is stays.
  constexpr double most = 0.27;  // of the height
  const double height = painter.fontMetrics().lineSpacing();
  const auto room = static_cast<qsizetype>((most * view.height() - overlayMargin) / height) - above;
  QStringList shown(above);
  for (const QString& line : lines.mid(0, std::max<qsizetype>(room, 1)))
    // No wider than a line of a corner, or it would be wrapped.
    shown << painter.fontMetrics().elidedText(line, Qt::ElideRight,
                                              static_cast<int>(0.5 * view.width() - overlayMargin) - 1);
  drawCorner(painter, view, Qt::AlignTop | Qt::AlignRight, shown, overlayGrey);
}

void drawEdgeLetters(QPainter& painter, const QRectF& view, glm::dvec3 right, glm::dvec3 down) {
  const auto letters = [](glm::dvec3 direction) { return QString::fromStdString(orientationLetters(direction)); };
  painter.save();
  QFont font = painter.font();
  font.setBold(true);
  font.setPointSizeF(font.pointSizeF() * 1.15);
  painter.setFont(font);
  const QRectF inside = view.adjusted(overlayMargin, overlayMargin, -overlayMargin, -overlayMargin);
  const QColor colour(255, 225, 150);
  drawText(painter, inside, Qt::AlignLeft | Qt::AlignVCenter, letters(-right), colour);
  drawText(painter, inside, Qt::AlignRight | Qt::AlignVCenter, letters(right), colour);
  drawText(painter, inside, Qt::AlignTop | Qt::AlignHCenter, letters(-down), colour);
  drawText(painter, inside, Qt::AlignBottom | Qt::AlignHCenter, letters(down), colour);
  painter.restore();
}

void drawScaleBar(QPainter& painter, const QRectF& view, double mmPerPixel) {
  const double limit = view.width() * 0.25 * mmPerPixel;
  if (!(limit > 0.0) || !std::isfinite(limit)) return;
  const double length = roundLength(limit);
  const QString text =
      length >= 10.0 ? QStringLiteral("%1 cm").arg(length / 10.0) : QStringLiteral("%1 mm").arg(length);
  const double pixels = length / mmPerPixel, tick = 4.0;
  const QPointF end(view.right() - overlayMargin, view.bottom() - overlayMargin - tick);
  const QPointF start = end - QPointF(pixels, 0);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (const QPen& pen : {QPen(rim, 3), QPen(overlayGrey, 1)}) {
    painter.setPen(pen);
    painter.drawLine(start, end);
    for (const QPointF& at : {start, end}) painter.drawLine(at - QPointF(0, tick), at + QPointF(0, tick));
  }
  painter.restore();
  const double height = painter.fontMetrics().height();
  drawText(painter, QRectF(start.x() - 40, end.y() - tick - height, pixels + 40, height),
           Qt::AlignRight | Qt::AlignBottom, text, overlayGrey);
}

void drawOrientationCube(QPainter& painter, const QRectF& box, const Camera::Axes& axes) {
  struct Face {
    const char* letter;
    glm::dvec3 normal, right, up;  // world; how the letter stands on the face, seen from outside
  };
  static const std::array<Face, 6> faces{{
      {"A", {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
      {"P", {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
      {"L", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {"R", {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
      {"S", {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
      {"I", {0, 0, -1}, {1, 0, 0}, {0, -1, 0}},
  }};
  // Half an edge: the cube's space diagonal fits the box.
  const double half = 0.5 * std::min(box.width(), box.height()) / std::sqrt(3.0);
  const auto toScreen = [&](glm::dvec3 world) {
    return box.center() + half * QPointF(glm::dot(world, axes.right), -glm::dot(world, axes.up));
  };
  painter.save();
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  QFont font = painter.font();
  font.setBold(true);
  for (const Face& face : faces) {
    const double facing = -glm::dot(face.normal, axes.forward);
    if (facing <= 0.02) continue;  // turned away, or seen edge-on
    const QPolygonF corners{toScreen(face.normal - face.right + face.up), toScreen(face.normal + face.right + face.up),
                            toScreen(face.normal + face.right - face.up), toScreen(face.normal - face.right - face.up)};
    const int shade = static_cast<int>(50 + 45 * facing);
    painter.setPen(QPen(QColor(15, 17, 20), 1));
    painter.setBrush(QColor(shade, shade + 6, shade + 14, 235));
    painter.drawPolygon(corners);
    QTransform onFace;
    constexpr double side = 20.0;
    const QPolygonF square{QPointF(0, 0), QPointF(side, 0), QPointF(side, side), QPointF(0, side)};
    if (facing > 0.3 && QTransform::quadToQuad(square, corners, onFace)) {
      painter.save();
      painter.setTransform(onFace, true);
      font.setPixelSize(14);
      painter.setFont(font);
      painter.setPen(QColor(255, 225, 150, static_cast<int>(255 * std::min(1.0, facing * 1.4))));
      painter.drawText(QRectF(0, 0, side, side), Qt::AlignCenter, QLatin1String(face.letter));
      painter.restore();
    }
  }
  painter.restore();
}

void drawMark(QPainter& painter, QPointF at) {
  constexpr double inner = 4.0, outer = 10.0;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const QPen& pen : {QPen(rim, 3.5), QPen(QColor(110, 215, 255), 1.5)}) {
    painter.setPen(pen);
    for (const QPointF& arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
      painter.drawLine(at + arm * inner, at + arm * outer);
  }
  painter.restore();
}

void drawSeed(QPainter& painter, QPointF at, bool inside) {
  constexpr double radius = 6.0, arm = 3.2;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(rim, 1.0));
  painter.setBrush(inside ? QColor(86, 196, 110) : QColor(226, 96, 84));
  painter.drawEllipse(at, radius, radius);
  painter.setPen(QPen(Qt::white, 1.8));
  painter.drawLine(at - QPointF(arm, 0.0), at + QPointF(arm, 0.0));
  if (inside) painter.drawLine(at - QPointF(0.0, arm), at + QPointF(0.0, arm));
  painter.restore();
}

}  // namespace fenestra::viewer
