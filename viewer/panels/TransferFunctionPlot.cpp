#include "viewer/panels/TransferFunctionPlot.h"

#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QPainterPath>

#include "viewer/model/Document.h"
#include "viewer/style/Overlay.h"

namespace fenestra::viewer {
namespace {

constexpr std::size_t bins = 256;

}  // namespace

TransferFunctionPlot::TransferFunctionPlot(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  connect(&document, &Document::volumeChanged, this, &TransferFunctionPlot::countValues);
  connect(&document, &Document::transferFunctionChanged, this, [this] { update(); });
}

void TransferFunctionPlot::countValues() {
  const Volume& volume = *document_.scene().volume;
  shown_ = volume.range;
  std::vector<double> counts(bins, 0.0);
  const double scale = bins / std::max(shown_.high - shown_.low, 1e-12);
  volume.voxels.visit([&](auto scalars) {
    // A quarter of a million voxels give the same curve as all of them.
    const std::size_t stride = std::max<std::size_t>(1, scalars.size() >> 18);
    for (std::size_t i = 0; i < scalars.size(); i += stride) {
      const double bin = (volume.slope * static_cast<double>(scalars[i]) + volume.intercept - shown_.low) * scale;
      if (std::isfinite(bin)) counts[static_cast<std::size_t>(std::clamp(bin, 0.0, bins - 1.0))] += 1.0;
    }
  });
  const double greatest = std::max(1.0, *std::max_element(counts.begin(), counts.end()));
  histogram_.resize(bins);
  std::transform(counts.begin(), counts.end(), histogram_.begin(),
                 [&](double count) { return static_cast<float>(std::log1p(count) / std::log1p(greatest)); });
  update();
}

void TransferFunctionPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), QColor(18, 20, 23));
  if (histogram_.empty()) return;
  const QRectF area = QRectF(rect()).adjusted(1, 3, -1, -1);

  QPainterPath counts(area.bottomLeft());
  for (std::size_t bin = 0; bin < bins; ++bin)
    counts.lineTo(area.left() + area.width() * (static_cast<double>(bin) + 0.5) / bins,
                  area.bottom() - area.height() * static_cast<double>(histogram_[bin]));
  counts.lineTo(area.bottomRight());
  painter.fillPath(counts, QColor(62, 68, 76));

  const TransferFunction function = document_.scene().look.context.shifted();
  const auto at = [&](double x) { return shown_.low + (x - area.left()) / area.width() * (shown_.high - shown_.low); };
  QPointF last;
  for (double x = area.left(); x <= area.right(); x += 1.0) {
    const OpticalProperties properties = function.evaluate(at(x));
    const QPointF point(x, area.bottom() - area.height() * opacityFromExtinction(properties.extinction));
    if (x > area.left()) {
      painter.setPen(QPen(toColour(properties.colour), 2));
      painter.drawLine(last, point);
    }
    last = point;
  }
}

}  // namespace fenestra::viewer
