#pragma once
// Line charts as SVG: enough for measurements, on linear or logarithmic axes.

#include <string>
#include <vector>

namespace fenestra::bench {

struct ChartPoint {
  double x = 0.0, y = 0.0;
  double low = 0.0, high = 0.0;  ///< of y, drawn as a whisker; equal to y for none
  std::string label;             ///< beside the point, or empty
};

struct ChartSeries {
  std::string name;
  std::vector<ChartPoint> points;
  std::vector<ChartPoint> apart{};  ///< drawn as rings and not joined by the line
};

struct Axis {
  std::string title;
  bool logarithmic = true;
};

/// Points that are not finite, or not positive on a logarithmic axis, are left out.
struct Chart {
  std::string name;  ///< of its SVG file
  std::string title;
  Axis x, y;
  std::vector<ChartSeries> series;
};

std::string svg(const Chart& chart);

}  // namespace fenestra::bench
