#include "rendering/viewpoints/RankCorrelation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace fenestra::placement {
namespace {

/// 0 for the least; equal values have the mean of their ranks.
std::vector<double> ranksOf(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
    for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = 0.5 * static_cast<double>(begin + end - 1);
  }
  return ranks;
}

}  // namespace

double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> left, right;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    if (!std::isnan(a[i]) && !std::isnan(b[i])) {
      left.push_back(a[i]);
      right.push_back(b[i]);
    }
  left = ranksOf(left);
  right = ranksOf(right);
  const double middle = 0.5 * (static_cast<double>(left.size()) - 1.0);
  double both = 0.0, ofLeft = 0.0, ofRight = 0.0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    both += (left[i] - middle) * (right[i] - middle);
    ofLeft += (left[i] - middle) * (left[i] - middle);
    ofRight += (right[i] - middle) * (right[i] - middle);
  }
  if (ofLeft == 0.0 || ofRight == 0.0) return std::numeric_limits<double>::quiet_NaN();
  return both / std::sqrt(ofLeft * ofRight);
}

}  // namespace fenestra::placement
