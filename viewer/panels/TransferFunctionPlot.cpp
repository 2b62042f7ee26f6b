#include "viewer/panels/TransferFunctionPlot.h"

#include <algorithm>
#include <cmath>

#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include "viewer/model/Document.h"
#include "viewer/model/NumberText.h"
#include "viewer/style/Overlay.h"

namespace fenestra::viewer {
namespace {

// Plots have these colours in both themes, as pictures have theirs.
const QColor paper(18, 20, 23), bars(62, 68, 76), gridLines(44, 48, 54), faint(150, 156, 164), chosen(255, 196, 84),
    ring(110, 163, 210);
constexpr double handleRadius = 4.5, chosenRadius = 6.0;  ///< device-independent pixels, as all below
constexpr double rightMargin = 10.0, topMargin = 10.0;

QString percentText(int percent) { return TransferFunctionPlot::tr("%1 %").arg(percent); }

/// 1, 2 or 5 times a power of ten, the least that is not below `least`.
double roundStep(double least) {
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * decade >= least * (1.0 - 1e-9)) return step * decade;
  return 10.0 * decade;
}

}  // namespace

TransferFunctionPlot::TransferFunctionPlot(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Transfer function over the histogram"));
  connect(&document, &Document::volumeChanged, this, &TransferFunctionPlot::countValues);
  for (const auto signal : {&Document::transferFunctionChanged, &Document::focusChanged,
                            &Document::labelSettingsChanged, &Document::labelsChanged})
    connect(&document, signal, this, &TransferFunctionPlot::follow);
}

void TransferFunctionPlot::countValues() {
  drag_.reset();
  if (!document_.hasVolume()) {
    histogram_ = {};
    labelHistogram_.reset();
    counted_ = {};
    target_ = {};
    Q_EMIT changed();
    return update();
  }
  histogram_ = histogramOf(*document_.scene().volume);
  countLabel();
  axis_ = {0.0, 0.0};
  fitAxis();
  shown_ = axis_;
  selected_ = 0;
  Q_EMIT changed();
  update();
}

/// The voxels of the label that is shown.
void TransferFunctionPlot::countLabel() {
  const std::shared_ptr<const LabelMap> labels =
      target_.kind == FunctionTarget::Kind::Label ? document_.labels() : nullptr;
  if (!labels) {
    labelHistogram_.reset();
    return;
  }
  const Counted counted{labels, document_.scene().volume, target_.label};
  if (labelHistogram_ && counted_ == counted) return;
  counted_ = counted;
  labelHistogram_ = histogramOf(*counted.volume, *labels, target_.label);
}

void TransferFunctionPlot::setByValue(bool byValue) {
  if (!document_.hasVolume() || drag_) return;
  constexpr double outliers = 0.02;
  ValueRange values = document_.scene().volume->range;
  if (const auto* range = std::get_if<ValueFocus>(&document_.focus())) values = range->values;
  if (labelHistogram_) values = middleOf(*labelHistogram_, outliers);
  viewer::setByValue(target_, document_, byValue, values);
}

/// The volume's values and all nodes, where those do not lie far beyond the values.
void TransferFunctionPlot::fitAxis() {
  const ValueRange values = document_.scene().volume->range;
  const double span = std::max(values.high - values.low, 1e-12 * std::max(1.0, std::abs(values.high)));
  const ValueRange before = axis_;
  axis_ = {values.low, values.low + span};
  const auto include = [&](const TransferFunction& function) {
    for (const TransferFunction::Node& node : function.nodes) {
      axis_.low = std::min(axis_.low, std::max(node.value, values.low - span));
      axis_.high = std::max(axis_.high, std::min(node.value, values.high + span));
    }
  };
  include(document_.look().context.shifted());
  if (isByValue(target_, document_)) include(function());
  if (shown_.low == before.low && shown_.high == before.high) shown_ = axis_;
  showValues(shown_);
}

void TransferFunctionPlot::follow() {
  if (!document_.hasVolume()) return;
  const std::vector<FunctionTarget> targets = targetsOf(document_);
  if (std::find(targets.begin(), targets.end(), target_) == targets.end()) target_ = {};
  countLabel();
  if (!drag_) fitAxis();
  Q_EMIT changed();
  update();
}

void TransferFunctionPlot::setTarget(const FunctionTarget& target) {
  if (target == target_) return;
  cancelDrag();
  target_ = target;
  selected_ = 0;
  isTrapezoidSelected_ = false;
  follow();
}

TransferFunction TransferFunctionPlot::function() const {
  return document_.hasVolume() ? functionOf(target_, document_, axis_) : TransferFunction{};
}

std::optional<std::size_t> TransferFunctionPlot::selected() const {
  const std::size_t count = function().nodes.size();
  if (count == 0) return std::nullopt;
  return std::min(selected_, count - 1);
}

void TransferFunctionPlot::select(std::size_t node) {
  selected_ = node;
  isTrapezoidSelected_ = false;
  Q_EMIT changed();
  update();
}

void TransferFunctionPlot::selectTrapezoid(std::size_t first) {
  select(first + 1);
  isTrapezoidSelected_ = true;
}

QFont TransferFunctionPlot::axisFont() const {
  QFont small = font();
  small.setPointSizeF(0.8 * small.pointSizeF());
  return small;
}

QRectF TransferFunctionPlot::area() const {
  const QFontMetricsF text(axisFont());
  return QRectF(rect()).adjusted(text.horizontalAdvance(percentText(100)) + 8.0, topMargin, -rightMargin,
                                 -text.height() - 6.0);
}

QPointF TransferFunctionPlot::place(double value, double opacity) const {
  const QRectF plot = area();
  const double along = (value - shown_.low) / (shown_.high - shown_.low);
  constexpr double farthest = 1e4;  // widths, which painters can still handle
  return {plot.left() + std::clamp(along, -farthest, farthest) * plot.width(), plot.bottom() - opacity * plot.height()};
}

double TransferFunctionPlot::valueAt(double x) const {
  const QRectF plot = area();
  return shown_.low + (x - plot.left()) / plot.width() * (shown_.high - shown_.low);
}

double TransferFunctionPlot::opacityAt(double y) const {
  return std::clamp((area().bottom() - y) / area().height(), 0.0, 1.0);
}

void TransferFunctionPlot::showValues(ValueRange values) {
  const double span = values.high - values.low;
  const double low = std::clamp(values.low, axis_.low, std::max(axis_.low, axis_.high - span));
  shown_ = span < axis_.high - axis_.low ? ValueRange{low, low + span} : axis_;
  update();
}

void TransferFunctionPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), paper);
  if (document_.hasVolume() && !histogram_.counts.empty()) {
    drawHistogram(painter);
    drawAxes(painter);
    drawFunction(painter);
    drawHandles(painter);
  }
  if (!hasFocus()) return;
  painter.setPen(QPen(ring, 2.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
}

void TransferFunctionPlot::drawHistogram(QPainter& painter) const {
  const QRectF plot = area();
  const ValueHistogram& histogram = labelHistogram_ ? *labelHistogram_ : histogram_;
  std::vector<double> heights;
  for (double x = plot.left(); x < plot.right(); x += 1.0)
    heights.push_back(std::log1p(histogram.density({valueAt(x), valueAt(x + 1.0)})));
  const double greatest = std::max(1e-9, *std::max_element(heights.begin(), heights.end()));
  QPainterPath counts(plot.bottomLeft());
  double x = plot.left();
  for (const double height : heights) {
    const double y = plot.bottom() - plot.height() * height / greatest;
    counts.lineTo(x, y);
    x = std::min(x + 1.0, plot.right());
    counts.lineTo(x, y);
  }
  counts.lineTo(plot.bottomRight());
  painter.fillPath(counts, bars);
}

void TransferFunctionPlot::drawAxes(QPainter& painter) const {
  const QRectF plot = area();
  painter.setFont(axisFont());
  const QFontMetricsF metrics(axisFont());
  const double line = metrics.height();
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  for (const double opacity : {0.0, 0.5, 1.0}) {
    const double y = place(shown_.low, opacity).y();
    painter.setPen(QPen(gridLines, 1.0));
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    painter.setPen(faint);
    painter.drawText(QRectF(0.0, y - (opacity > 0.0 ? 0.5 : 0.9) * line, plot.left() - 4.0, line),
                     Qt::AlignRight | Qt::AlignVCenter, percentText(static_cast<int>(std::lround(100.0 * opacity))));
  }
  const QString unit = unitText(document_.scene().volume->unit);
  const double below = plot.bottom() + 3.0;
  const double unitWidth = unit.isEmpty() ? 0.0 : metrics.horizontalAdvance(unit) + 6.0;
  painter.drawText(QRectF(rect().right() - unitWidth, below, unitWidth - 3.0, line), Qt::AlignRight | Qt::AlignTop,
                   unit);
  constexpr double pixelsPerTick = 56.0;
  const double step = roundStep((shown_.high - shown_.low) * pixelsPerTick / plot.width());
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  for (double tick = std::ceil(shown_.low / step); tick * step <= shown_.high; tick += 1.0) {
    const double x = place(tick * step, 0.0).x();
    const QString text =
        step >= 1e6 ? locale.toString(tick * step, 'g', 3) : locale.toString(tick * step, 'f', decimals);
    const double half = 0.5 * metrics.horizontalAdvance(text);
    painter.drawLine(QPointF(x, plot.bottom()), QPointF(x, plot.bottom() + 3.0));
    if (x + half > rect().right() - unitWidth || x - half < 0.0) continue;
    painter.drawText(QRectF(x - half - 2.0, below, 2.0 * half + 4.0, line), Qt::AlignHCenter | Qt::AlignTop, text);
  }
}

void TransferFunctionPlot::drawFunction(QPainter& painter) const {
  const QRectF plot = area();
  const TransferFunction function = this->function();
  // Steps show as vertical lines: each node is drawn, and single pixels between the nodes.
  std::vector<QPointF> points;
  std::vector<QColor> colours;
  const auto add = [&](double value, const OpticalProperties& properties) {
    points.push_back(place(value, opacityFromExtinction(properties.extinction)));
    colours.push_back(toColour(properties.colour));
  };
  const bool isBox = !hasNodes(target_, document_) && hasValues(target_, document_);
  auto node = function.nodes.begin();
  for (double x = plot.left(); x <= plot.right(); x += 1.0) {
    const double value = valueAt(x);
    for (; node != function.nodes.end() && node->value <= value; ++node)
      if (node->value >= shown_.low) add(node->value, node->properties);
    add(value, isBox && (value < function.nodes.front().value || value > function.nodes.back().value)
                   ? OpticalProperties{function.nodes.front().properties.colour, 0.0}
                   : function.evaluate(value));
  }
  painter.save();
  painter.setClipRect(plot.adjusted(-1, -3, 1, 3));
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    QColor fill = colours[i];
    fill.setAlphaF(0.35);
    const QPolygonF strip{
        {points[i], points[i + 1], QPointF(points[i + 1].x(), plot.bottom()), QPointF(points[i].x(), plot.bottom())}};
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawPolygon(strip);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    painter.setPen(QPen(colours[i], 2.0));
    painter.drawLine(points[i], points[i + 1]);
  }
  painter.restore();
}

void TransferFunctionPlot::drawHandles(QPainter& painter) const {
  const QRectF plot = area();
  const TransferFunction function = this->function();
  const auto [first, last] = selection();
  for (std::size_t node = 0; node < function.nodes.size(); ++node) {
    const TransferFunction::Node& each = function.nodes[node];
    const QPointF at = place(each.value, opacityFromExtinction(each.properties.extinction));
    if (at.x() < plot.left() - 0.5 || at.x() > plot.right() + 0.5) continue;
    const bool isSelected = node >= first && node < last;
    painter.setPen(QPen(isSelected ? chosen : QColor(Qt::white), isSelected ? 2.0 : 1.2));
    painter.setBrush(toColour(each.properties.colour));
    const double radius = isSelected ? chosenRadius : handleRadius;
    painter.drawEllipse(at, radius, radius);
  }
}

}  // namespace fenestra::viewer
