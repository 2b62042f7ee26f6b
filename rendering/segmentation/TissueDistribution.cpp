#include "rendering/segmentation/TissueDistribution.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

/// Two classes of sorted values.
struct Split {
  std::size_t below = 0;   ///< how many values are of the lower class
  double explained = 0.0;  ///< share of the variance that lies between the classes, 0 … 1
};

/// The first `count` sorted values, parted where the variance between the classes is greatest (Otsu's method).
Split bestSplit(const std::vector<double>& values, std::size_t count) {
  Split split;
  if (count == 0) return split;
  // Outliers (metal, a spike) would be a class of their own.
  const std::size_t tail = count / 1000;
  const auto clipped = [&](std::size_t i) { return std::clamp(values[i], values[tail], values[count - 1 - tail]); };
  double total = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < count; ++i) total += clipped(i);
  const auto all = static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) squares += (clipped(i) - total / all) * (clipped(i) - total / all);
  double below = 0.0, greatest = 0.0;
  for (std::size_t i = 1; i < count; ++i) {
    below += clipped(i - 1);
    if (values[i] == values[i - 1]) continue;
    const double n = static_cast<double>(i);
    const double difference = below / n - (total - below) / (all - n);
    const double between = n * (all - n) * difference * difference;
    if (between > greatest) {
      greatest = between;
      split.below = i;
    }
  }
  if (squares > 0.0) split.explained = greatest / (all * squares);
  return split;
}

/// The split of one class in two explains 0.64 of the variance of a normal distribution, 0.66 of the noise of air in a
/// magnitude image (Rayleigh's distribution), and 0.75 where all values are as frequent. More tells of two classes: air
/// beside dark tissue explains 0.81 to 0.93 in T1 of heads and of a knee.
constexpr double leastExplained = 0.78;

}  // namespace

TissueDistribution::TissueDistribution(const Volume& volume, Background background) : values_(sampled(volume)) {
  std::size_t count = bestSplit(values_, values_.size()).below;
  if (background == Background::Air)
    if (const Split split = bestSplit(values_, count); split.explained >= leastExplained) count = split.below;
  if (background == Background::Air && count > 0) values_[count] = std::midpoint(values_[count - 1], values_[count]);
  values_.erase(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(count));
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
