// How a slice looks on the screen: its picture with outlines and marks.

#include <algorithm>
#include <cmath>

#include <QHelpEvent>
#include <QLineF>
#include <QPainter>

#include "viewer/model/Document.h"
#include "viewer/model/NumberText.h"
#include "viewer/model/PatientLines.h"
#include "viewer/model/SlabText.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/SlicePlanes.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/style/InterpolatedPlanes.h"
#include "viewer/style/Overlay.h"
#include "viewer/views/FidelityChip.h"
#include "viewer/views/RegionMark.h"
#include "viewer/views/SliceView.h"

namespace fenestra::viewer {

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  draw(painter, true);
  // Not one of the marks, because saved pictures must not name the patient.
  if (document_.hasVolume() && options_.text() && !options_.hidesPatient())
    drawStudyText(painter, rect(), patientLines(document_.study().patient, document_.study().series), 1);
  if (document_.hasVolume() && hasFocus()) {
    painter.setPen(QColor(86, 140, 190));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void SliceView::draw(QPainter& painter, bool marks) {
  painter.fillRect(rect(), Qt::black);
  if (!document_.hasVolume()) return;
  preparePicture();
  if (image_.isNull()) makeImage();

  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF whole(0.0, 0.0, picture_.geometry.width, picture_.geometry.height);
  if (turn() == Turn{}) {
    painter.drawImage(widgetFromPixels().mapRect(whole), image_);
  } else {
    painter.save();
    painter.setTransform(widgetFromPixels(), true);
    painter.drawImage(whole, image_);
    painter.restore();
  }

  drawOutlines(painter);
  const bool interpolated = drawInterpolated(painter);
  if (marks) drawMarks(painter, interpolated);
}

QString SliceView::name() const { return planeName(geometry_.plane); }

bool SliceView::showsText() const { return options_.text(); }

std::vector<FidelityCause> SliceView::fidelity() const {
  return fidelityOf(document_.study(), document_.scene(),
                    {.is3D = false,
                     .isCurrent = !lateness_.isLate(),
                     .isDraft = planes_.isMoving(geometry_.plane),
                     .scale = 0.5,
                     .isInterpolated = showsInterpolated(),
                     .isTurned = planes_.isTurned(geometry_.plane),
                     .slab = planes_.pose(geometry_.plane).slab});
}

bool SliceView::showsInterpolated() const {
  const std::optional<io::GeometryReport>& report = document_.study().geometry;
  return report && isInterpolated(report->interpolatedPlanes, document_.scene().volume->grid, geometry_, slice_);
}

bool SliceView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && document_.hasVolume()) {
    const auto& help = static_cast<QHelpEvent&>(*event);
    if (showFidelity(help, *this, fidelity())) return true;
  }
  return QWidget::event(event);
}

void SliceView::drawMarks(QPainter& painter, bool interpolated) const {
  if (options_.labels()) drawSeeds(painter);
  if (options_.crosshair()) drawCrosshair(painter);
  const QRectF view = rect();
  drawFidelity(painter, view, fidelity());
  if (lateness_.isLate() || document_.asksToOpen()) {
    const QString region = regionMark(document_);
    drawWaiting(painter, view, region.isEmpty() ? tr("Not yet as asked for") : region);
  }
  tools_.draw(painter, view);
  drawEdgeLetters(painter, view, screenRight(), screenDown());
  drawScaleBar(painter, view, 1.0 / pixelsPerMm());
  QStringList title{name()};
  if (interpolated) title << tr("Interpolated, not scanned");
  title << planeText();
  if (options_.text()) {
    title << tr("%1 / %2").arg(slice_ + 1).arg(geometry_.count).replace(QLatin1Char(' '), QChar(QChar::Nbsp));
    drawCorner(painter, view, Qt::AlignBottom | Qt::AlignLeft, windowText(painter.fontMetrics()), overlayGrey);
    const QStringList convention = conventionText();
    const bool fits = std::all_of(convention.begin(), convention.end(),
                                  [&](const QString& line) { return fitsBesideLetter(painter, view, line); });
    if (fits && !convention.isEmpty())
      drawCorner(painter, view, Qt::AlignTop | Qt::AlignRight, convention, overlayGrey);
    else
      title << convention;
  }
  drawCorner(painter, besideChip(view), Qt::AlignTop | Qt::AlignLeft, title, planeColour(geometry_.plane));
}

QStringList SliceView::conventionText() const {
  QStringList text;
  // Where left and right could be mistaken. In world coordinates the first axis points to the patient's left.
  // A turned slice has its letters.
  if (geometry_.plane != SlicePlane::Sagittal && !planes_.isTurned(geometry_.plane)) {
    const glm::dvec3 right = glm::normalize(screenRight());
    constexpr double mostly = 0.7;  // about the cosine of 45 degrees: farther off, left is above or below
    if (right.x > mostly) text << tr("Radiological");
    if (right.x < -mostly) text << tr("Neurological");
  }
  if (turn_.mirrored) text << tr("flipped");
  if (turn_.quarters) text << tr("turned by %1°").arg(90 * turn_.quarters);
  if (isTrueSize()) text << tr("true size");
  return text;
}

void SliceView::drawOutlines(QPainter& painter) const {
  if (!options_.labels()) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  // Line by line, and no wider than a pixel where possible: Qt draws these ten times as fast as one path of all lines,
  // and a focus by values has many.
  const auto drawLines = [&painter](const QList<QPolygonF>& lines, const QPen& pen) {
    painter.setPen(pen);
    for (const QPolygonF& line : lines) painter.drawPolygon(line);
  };
  const QList<QPolygonF> opening = openingEdge().toSubpathPolygons();
  QPen dashes(toColour(document_.look().cutaway.borderColour), 1.0);
  dashes.setDashPattern({6.0, 5.0});
  // A dark line below, so that the dashes show on bone.
  drawLines(opening, QPen(QColor(0, 0, 0, 150), 2.4));
  drawLines(opening, dashes);
  const QTransform transform = widgetFromPixels();
  QList<QPolygonF> removed;
  for (const QPolygonF& line : removedOutline()) removed << transform.map(line);
  drawLines(removed, QPen(QColor(0, 0, 0, 150), 2.4));
  drawLines(removed, QPen(QColor(255, 170, 110), 1.0));
  QList<QPolygonF> outline;
  for (const QPolygonF& line : outline_) outline << transform.map(line);
  drawLines(outline, QPen(QColor(255, 240, 190), 1.0));
  QPen coming(toColour(segmentation::regionColour), 1.0);
  coming.setDashPattern({4.0, 3.0});
  QList<QPolygonF> awaited;
  for (const QPolygonF& line : awaitedOutline_) awaited << transform.map(line);
  drawLines(awaited, QPen(QColor(0, 0, 0, 150), 2.4));
  drawLines(awaited, coming);
  painter.restore();
}

QStringList SliceView::windowText(const QFontMetrics& metrics) const {
  const WindowLevel window = document_.window();
  const int decimals = window.width < 10.0 ? 2 : 0;
  QString level = tr("L %1").arg(window.level, 0, 'f', decimals);
  if (const std::string& unit = document_.scene().volume->unit; !unit.empty()) level += unitSuffix(unit);
  QStringList parts{tr("W %1").arg(window.width, 0, 'f', decimals), level};
  if (document_.isInverted()) parts << tr("inverted");
  // The letter of the patient's side stands in the middle of the edge.
  const QString line = parts.join(QStringLiteral("  "));
  const int letter = 2 * metrics.horizontalAdvance(QLatin1Char('W'));
  return metrics.horizontalAdvance(line) + letter < width() / 2 ? QStringList{line} : parts;
}

bool SliceView::drawInterpolated(QPainter& painter) const {
  const std::optional<io::GeometryReport>& report = document_.study().geometry;
  if (!report || report->interpolatedPlanes.empty() || planes_.isTurned(geometry_.plane)) return false;
  const Grid& grid = document_.scene().volume->grid;
  drawInterpolatedBands(painter, interpolatedBands(report->interpolatedPlanes, grid, geometry_, slice_),
                        widgetFromPixels());
  return showsInterpolated();
}

void SliceView::drawCrosshair(QPainter& painter) const {
  constexpr double gap = 10.0;  // around the crossing, so that the lines do not cover the voxel
  painter.save();
  for (const PlaneCut& cut : planeTool_.cuts()) {
    // A line along the picture's rows or columns stays one pixel wide.
    const bool isOblique = std::abs(cut.along.x() * cut.along.y()) > 1e-6;
    painter.setRenderHint(QPainter::Antialiasing, isOblique);
    QColor colour = planeColour(cut.plane);
    colour.setAlpha(170);
    painter.setPen(QPen(colour, isOblique ? 1.2 : 1.0));
    const QPointF middle = QRectF(rect()).center();
    // Beyond the view's edge, wherever the crosshair is.
    const double reach = QLineF(cut.at, middle).length() + std::hypot(width(), height());
    for (const double side : {-1.0, 1.0})
      painter.drawLine(cut.at + side * gap * cut.along, cut.at + side * reach * cut.along);
  }
  painter.restore();
}

QStringList SliceView::planeText() const {
  QStringList text;
  const PlanePose& pose = planes_.pose(geometry_.plane);
  const auto joined = [](QString line) { return line.replace(QLatin1Char(' '), QChar(QChar::Nbsp)); };
  if (pose.axes) {
    const PlaneTilt tilt = planes_.tilt(geometry_.plane);
    const QString degrees = QString::number(tilt.degrees, 'f', tilt.degrees < 9.95 ? 1 : 0);
    const QString from = planeName(tilt.from).toLower();
    text << (pose.follow == PlaneFollow::None ? tr("Oblique, %1° from %2").arg(degrees, from)
             : pose.follow == PlaneFollow::C1 ? tr("Faces C1, %1° from %2").arg(degrees, from)
                                              : tr("Faces C2, %1° from %2").arg(degrees, from));
  }
  if (pose.slab.thickness > 0.0) text << joined(slabText(pose.slab));
  return text;
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

}  // namespace fenestra::viewer
