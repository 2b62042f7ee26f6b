#include "rendering/segmentation/TissueDistribution.h"

#include <algorithm>
#include <cmath>

namespace fenestra::segmentation {
namespace {

/// Finite real values of evenly spaced voxels, sorted. A quarter of a million give a percentile to a tenth of one.
std::vector<double> sampled(const Volume& volume) {
  constexpr std::size_t wanted = 1 << 18;
  std::vector<double> values;
  volume.voxels.visit([&](auto scalars) {
    // An odd stride does not fall into step with rows whose length is a power of two.
    const std::size_t stride = scalars.size() / wanted | 1;
    values.reserve(scalars.size() / stride + 1);
    for (std::size_t i = 0; i < scalars.size(); i += stride) {
      const double real = volume.slope * static_cast<double>(scalars[i]) + volume.intercept;
      if (std::isfinite(real)) values.push_back(real);
    }
  });
  std::sort(values.begin(), values.end());
  return values;
}

/// How many of the sorted values are background: air and its noise, below the threshold that separates the two
/// classes best (Otsu, IEEE Trans. SMC 9(1), 1979: the greatest variance between classes).
std::ptrdiff_t backgroundCount(const std::vector<double>& values) {
  // Outliers (metal, a spike) would be a class of their own.
  const std::size_t tail = values.size() / 1000;
  const auto clipped = [&](std::size_t i) {
    return std::clamp(values[i], values[tail], values[values.size() - 1 - tail]);
  };
  double total = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) total += clipped(i);
  const auto count = static_cast<double>(values.size());
  double below = 0.0, greatest = 0.0;
  std::size_t split = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    below += clipped(i - 1);
    if (values[i] == values[i - 1]) continue;
    const double n = static_cast<double>(i);
    const double difference = below / n - (total - below) / (count - n);
    const double between = n * (count - n) * difference * difference;
    if (between > greatest) {
      greatest = between;
      split = i;
    }
  }
  return static_cast<std::ptrdiff_t>(split);
}

}  // namespace

TissueDistribution::TissueDistribution(const Volume& volume) : values_(sampled(volume)) {
  if (!values_.empty()) values_.erase(values_.begin(), values_.begin() + backgroundCount(values_));
}

double TissueDistribution::at(double percentile) const {
  if (values_.empty()) return 0.0;
  const double position = percentile / 100.0 * static_cast<double>(values_.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const auto above = std::min(below + 1, values_.size() - 1);
  return std::lerp(values_[below], values_[above], position - static_cast<double>(below));
}

double TissueDistribution::mean() const {
  double sum = 0.0;
  for (const double value : values_) sum += value;
  return values_.empty() ? 0.0 : sum / static_cast<double>(values_.size());
}

double TissueDistribution::shareAbove(double value) const {
  if (values_.empty()) return 0.0;
  return static_cast<double>(values_.end() - std::upper_bound(values_.begin(), values_.end(), value)) /
         static_cast<double>(values_.size());
}

}  // namespace fenestra::segmentation
