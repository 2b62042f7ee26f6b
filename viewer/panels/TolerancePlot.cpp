#include "viewer/panels/TolerancePlot.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include "rendering/segmentation/RegionGrowing.h"
#include "viewer/model/Document.h"

namespace fenestra::viewer {
namespace {

using segmentation::stepCount;

const QColor curvePaper(18, 20, 23), fill(62, 68, 76), line(196, 202, 210), plateau(86, 196, 110),
    present(255, 196, 84), curveFaint(128, 133, 140);

/// "0.01 ml", "12 ml".
QString cornerVolumeText(double ml) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(1.0 - std::log10(std::max(ml, 1e-6)))), 0, 4);
  return TolerancePlot::tr("%1 ml").arg(ml, 0, 'f', decimals);
}

/// The logarithms of the curve's volumes, and their range in whole powers of ten.
struct LogCurve {
  std::vector<double> decades;  ///< log₁₀ of ml, one a step from 1 on; empty steps have that of the first region
  double low = -3.0, high = 0.0;

  explicit LogCurve(const segmentation::GrowthCurve& curve) {
    double least = 0.0;
    for (const double volume : curve.volume)
      if (volume > 0.0 && (least == 0.0 || volume < least)) least = volume;
    for (int step = 1; step <= stepCount; ++step)
      decades.push_back(std::log10(std::max({curve.volume[static_cast<std::size_t>(step)], least, 1e-9}) / mm3PerMl));
    low = std::floor(decades.front());
    high = std::max(low + 1.0, std::ceil(decades.back()));
  }
};

}  // namespace

TolerancePlot::TolerancePlot(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setToolTip(
      tr("The region's volume against its tolerance, both logarithmic. A cliff is a leak; green marks where the region "
         "hardly changes"));
  connect(&document, &Document::focusChanged, this, [this] { update(); });
}

QRectF TolerancePlot::area() const { return QRectF(rect()).adjusted(4, 4, -4, -4); }

double TolerancePlot::xOf(int step) const {
  return area().left() + area().width() * (step - 1) / static_cast<double>(stepCount - 1);
}

int TolerancePlot::stepAt(double x) const {
  const double share = (x - area().left()) / area().width();
  return 1 + static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * (stepCount - 1)));
}

void TolerancePlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), curvePaper);
  const segmentation::Growth* growth = document_.growth();
  if (!growth) return;
  const QRectF plot = area();
  const LogCurve curve(growth->curve);
  const auto yOf = [&](double decade) {
    return plot.bottom() - plot.height() * (decade - curve.low) / (curve.high - curve.low);
  };

  QPainterPath level;  // one shape, because plateaus may overlap
  level.setFillRule(Qt::WindingFill);
  for (const segmentation::Plateau& each : growth->curve.plateaus)
    level.addRect(QRectF(QPointF(xOf(each.first) - 1.0, plot.top()), QPointF(xOf(each.last) + 1.0, plot.bottom())));
  painter.fillPath(level, QColor(plateau.red(), plateau.green(), plateau.blue(), 50));
  painter.setPen(QPen(fill, 1.0));
  for (double decade = curve.low; decade <= curve.high; decade += 1.0)
    painter.drawLine(QPointF(plot.left(), yOf(decade)), QPointF(plot.right(), yOf(decade)));

  QPainterPath path(QPointF(xOf(1), yOf(curve.decades.front())));
  for (int step = 2; step <= stepCount; ++step)
    path.lineTo(xOf(step), yOf(curve.decades[static_cast<std::size_t>(step - 1)]));
  painter.setPen(QPen(line, 1.4));
  painter.drawPath(path);
  painter.setPen(Qt::NoPen);
  painter.setBrush(plateau);
  for (const segmentation::Plateau& each : growth->curve.plateaus)
    painter.drawEllipse(QPointF(xOf(each.best), yOf(curve.decades[static_cast<std::size_t>(each.best - 1)])), 3.0, 3.0);

  const int now = std::max(1, document_.regionStep());
  const QPointF here(xOf(now), yOf(curve.decades[static_cast<std::size_t>(now - 1)]));
  painter.setPen(QPen(present, 1.2));
  painter.drawLine(QPointF(here.x(), plot.top()), QPointF(here.x(), plot.bottom()));
  painter.setBrush(present);
  painter.drawEllipse(here, 3.5, 3.5);
  QFont small = font();
  small.setPointSizeF(0.8 * small.pointSizeF());
  painter.setFont(small);
  painter.setPen(curveFaint);
  painter.drawText(plot.adjusted(2, 0, 0, 0), Qt::AlignLeft | Qt::AlignTop, cornerVolumeText(std::pow(10.0, curve.high)));
  painter.drawText(plot.adjusted(2, 0, 0, 0), Qt::AlignLeft | Qt::AlignBottom, cornerVolumeText(std::pow(10.0, curve.low)));
}

void TolerancePlot::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !document_.growth()) return;
  Q_EMIT dragBegun();
  Q_EMIT edited(stepAt(event->position().x()));
}

void TolerancePlot::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton && document_.growth()) Q_EMIT edited(stepAt(event->position().x()));
}

void TolerancePlot::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) Q_EMIT dragEnded();
}

}  // namespace fenestra::viewer
