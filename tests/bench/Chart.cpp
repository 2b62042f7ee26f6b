#include "tests/bench/Chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "app/benchmark/Numbers.h"
#include "tests/bench/Markup.h"

namespace fenestra::bench {
namespace {

// Tol's bright scheme, which colour-blind readers can tell apart.
constexpr std::array<const char*, 7> colours{"#4477aa", "#ee6677", "#228833", "#aa3377",
                                             "#ccbb44", "#66ccee", "#777777"};
// Pixels.
constexpr double left = 64.0, top = 34.0, width = 560.0, height = 340.0, legendRow = 18.0;
constexpr double right = left + width, bottom = top + height;

/// From values to pixels along one axis, with its ticks.
class Scale {
 public:
  Scale(bool logarithmic, double low, double high, double from, double to)
      : logarithmic_(logarithmic), from_(from), to_(to) {
    if (!(low <= high)) low = high = 1.0;
    if (logarithmic) {
      // Whole thirds of a decade (1, 2, 5) around the data.
      low_ = std::floor(std::log10(low) * 3.0 - 0.3) / 3.0;
      high_ = std::ceil(std::log10(high) * 3.0 + 0.3) / 3.0;
    } else {
      low_ = std::min(low, 0.0);
      high_ = high > low_ ? high + 0.05 * (high - low_) : low_ + 1.0;
    }
  }

  double operator()(double value) const {
    const double place = ((logarithmic_ ? std::log10(value) : value) - low_) / (high_ - low_);
    return from_ + (to_ - from_) * place;
  }

  std::vector<double> ticks() const {
    std::vector<double> values;
    if (logarithmic_) {
      // With many decades, their starts alone.
      const bool wide = high_ - low_ > 4.0;
      for (int decade = static_cast<int>(std::floor(low_)); decade <= static_cast<int>(std::ceil(high_)); ++decade)
        for (const double factor : {1.0, 2.0, 5.0}) {
          const double place = decade + std::log10(factor);
          if (place >= low_ - 1e-9 && place <= high_ + 1e-9 && !(wide && factor > 1.0))
            values.push_back(factor * std::pow(10.0, decade));
        }
      return values;
    }
    const double rough = (high_ - low_) / 6.0, unit = std::pow(10.0, std::floor(std::log10(rough)));
    const double step = unit * (rough / unit < 1.5 ? 1.0 : rough / unit < 3.5 ? 2.0 : rough / unit < 7.5 ? 5.0 : 10.0);
    for (double value = std::ceil(low_ / step) * step; value <= high_; value += step) values.push_back(value);
    return values;
  }

 private:
  bool logarithmic_;
  double low_ = 0.0, high_ = 1.0, from_, to_;
};

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

bool isDrawable(double value, const Axis& axis) { return std::isfinite(value) && (!axis.logarithmic || value > 0.0); }

/// What is drawn of a chart, and the values that its axes span.
struct Drawable {
  std::vector<ChartSeries> series;
  Range x, y;

  explicit Drawable(const Chart& chart) {
    for (const ChartSeries& all : chart.series)
      series.push_back({all.name, taken(all.points, chart), taken(all.apart, chart)});
  }

 private:
  std::vector<ChartPoint> taken(const std::vector<ChartPoint>& points, const Chart& chart) {
    std::vector<ChartPoint> drawn;
    for (const ChartPoint& point : points) {
      if (!isDrawable(point.x, chart.x) || !isDrawable(point.y, chart.y)) continue;
      drawn.push_back(point);
      x.take(point.x);
      for (const double value : {point.y, point.low, point.high})
        if (isDrawable(value, chart.y)) y.take(value);
    }
    return drawn;
  }
};

void drawAxes(std::ostream& out, const Chart& chart, const Scale& x, const Scale& y) {
  for (const double tick : x.ticks())
    out << "<line x1=\"" << x(tick) << "\" x2=\"" << x(tick) << "\" y1=\"" << top << "\" y2=\"" << bottom
        << "\" stroke=\"#ddd\"/><text x=\"" << x(tick) << "\" y=\"" << bottom + 16 << "\" text-anchor=\"middle\">"
        << number(tick) << "</text>\n";
  for (const double tick : y.ticks())
    out << "<line x1=\"" << left << "\" x2=\"" << right << "\" y1=\"" << y(tick) << "\" y2=\"" << y(tick)
        << "\" stroke=\"#ddd\"/><text x=\"" << left - 6 << "\" y=\"" << y(tick) + 4 << "\" text-anchor=\"end\">"
        << number(tick) << "</text>\n";
  out << "<text x=\"" << left + width / 2 << "\" y=\"" << bottom + 34 << "\" text-anchor=\"middle\">"
      << escaped(chart.x.title) << "</text>\n<text transform=\"translate(14 " << top + height / 2
      << ") rotate(-90)\" text-anchor=\"middle\">" << escaped(chart.y.title) << "</text>\n";
}

/// `ring`: the radius of the points apart, pixels.
void drawSeries(std::ostream& out, const ChartSeries& series, const char* colour, double ring, const Axis& yAxis,
                const Scale& x, const Scale& y) {
  out << "<g stroke=\"" << colour << "\" fill=\"none\" stroke-width=\"1.5\">\n<polyline points=\"";
  for (const ChartPoint& point : series.points) out << x(point.x) << ',' << y(point.y) << ' ';
  out << "\"/>\n";
  for (const ChartPoint& point : series.points)
    if (point.low != point.high && isDrawable(point.low, yAxis) && isDrawable(point.high, yAxis))
      out << "<line x1=\"" << x(point.x) << "\" x2=\"" << x(point.x) << "\" y1=\"" << y(point.low) << "\" y2=\""
          << y(point.high) << "\"/>\n";
  for (const ChartPoint& point : series.apart)
    out << "<circle cx=\"" << x(point.x) << "\" cy=\"" << y(point.y) << "\" r=\"" << ring << "\"/>\n";
  out << "</g>\n<g fill=\"" << colour << "\">\n";
  for (const ChartPoint& point : series.points) {
    out << "<circle cx=\"" << x(point.x) << "\" cy=\"" << y(point.y) << "\" r=\"3.5\"/>";
    if (!point.label.empty())
      out << "<text font-size=\"10\" x=\"" << x(point.x) + 5 << "\" y=\"" << y(point.y) - 5 << "\">"
          << escaped(point.label) << "</text>";
    out << '\n';
  }
}

}  // namespace

std::string svg(const Chart& chart) {
  const Drawable drawable(chart);
  const Scale x(chart.x.logarithmic, drawable.x.low, drawable.x.high, left, right);
  const Scale y(chart.y.logarithmic, drawable.y.low, drawable.y.high, bottom, top);

  std::ostringstream out;
  const double full = bottom + 56.0 + legendRow * std::ceil(static_cast<double>(drawable.series.size()) / 2.0);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << right + 30.0 << ' ' << full
      << "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      << "<text x=\"" << left << "\" y=\"18\" font-size=\"14\">" << escaped(chart.title) << "</text>\n";
  drawAxes(out, chart, x, y);
  for (std::size_t i = 0; i < drawable.series.size(); ++i) {
    const ChartSeries& series = drawable.series[i];
    // Each ring is wider than the ones before, so that those of one place show.
    drawSeries(out, series, colours[i % colours.size()], 5.0 + 1.5 * static_cast<double>(i), chart.y, x, y);
    const double lx = left + static_cast<double>(i % 2) * width / 2;
    const double ly = bottom + 56.0 + legendRow * static_cast<double>(i / 2);
    out << "<rect x=\"" << lx << "\" y=\"" << ly - 9 << "\" width=\"22\" height=\"4\"/></g>\n<text x=\"" << lx + 28
        << "\" y=\"" << ly - 2 << "\">" << escaped(series.name) << "</text>\n";
  }
  out << "</svg>\n";
  return out.str();
}

}  // namespace fenestra::bench
