#include "rendering/settings/TransferFunction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fenestra {

double extinctionFromOpacity(double opacityPerMm) {
  // Full opacity over 1 mm would need an infinite extinction; opacities end at 1 - 1e-6, which 8 bits cannot tell
  // from 1.
  return -std::log1p(-std::clamp(opacityPerMm, 0.0, 1.0 - 1e-6));
}

double opacityFromExtinction(double extinction) { return -std::expm1(-extinction); }

OpticalProperties TransferFunction::evaluate(double value) const {
  if (nodes.empty() || std::isnan(value)) return {};
  const auto after = std::upper_bound(nodes.begin(), nodes.end(), value,
                                      [](double wanted, const Node& node) { return wanted < node.value; });
  if (after == nodes.begin()) return nodes.front().properties;
  if (after == nodes.end()) return nodes.back().properties;
  const Node &a = *std::prev(after), &b = *after;
  const double s = (value - a.value) / (b.value - a.value);
  return {glm::mix(a.properties.colour, b.properties.colour, s),
          a.properties.extinction + s * (b.properties.extinction - a.properties.extinction)};
}

std::vector<ValueRange> TransferFunction::emptyRanges() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (nodes.empty()) return {{-infinity, infinity}};
  const auto shows = [](const Node& node) { return node.properties.extinction > 0.0; };
  std::vector<ValueRange> ranges;
  for (auto first = std::find_if_not(nodes.begin(), nodes.end(), shows); first != nodes.end();) {
    const auto end = std::find_if(first, nodes.end(), shows);
    ValueRange range{-infinity, infinity};
    if (first != nodes.begin()) {
      const bool isStep = std::prev(first)->value == first->value;
      range.low = isStep ? std::nextafter(first->value, infinity) : first->value;
    }
    if (end != nodes.end()) {
      const double last = std::prev(end)->value;
      range.high = end->value == last ? std::nextafter(last, -infinity) : last;
    }
    if (range.low <= range.high) ranges.push_back(range);
    first = std::find_if_not(end, nodes.end(), shows);
  }
  return ranges;
}

std::vector<ValueGap> TransferFunction::transparentGaps(double opacity) const {
  const double threshold = extinctionFromOpacity(opacity);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (nodes.empty()) return {{-infinity, infinity}};
  std::vector<ValueGap> gaps;
  bool open = nodes.front().properties.extinction <= threshold;
  double low = -infinity;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Node &a = nodes[i], &b = nodes[i + 1];
    const double ka = a.properties.extinction, kb = b.properties.extinction;
    const bool next = kb <= threshold;
    if (next == open) continue;
    const double crossing = a.value + (threshold - ka) / (kb - ka) * (b.value - a.value);
    if (open) {
      if (crossing > low) gaps.push_back({low, crossing});
    } else {
      low = crossing;
    }
    open = next;
  }
  if (open) gaps.push_back({low, infinity});
  return gaps;
}

}  // namespace fenestra
