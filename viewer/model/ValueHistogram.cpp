#include "viewer/model/ValueHistogram.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <type_traits>

#include "rendering/volume/Threads.h"

namespace fenestra::viewer {
namespace {

constexpr double mostBins = 4096.0;  ///< a plot of 250 pixels can be enlarged sixteen times

/// Bins without counts, and the width of each.
struct Bins {
  ValueHistogram empty;
  double width;

  std::size_t count() const { return empty.counts.size(); }
  /// The bin of a finite value; count() for others.
  std::size_t binOf(double value) const {
    const double bin = std::floor((value - empty.values.low) / width);
    return bin >= 0.0 && bin < static_cast<double>(count()) ? static_cast<std::size_t>(bin) : count();
  }
};

Bins binsOf(const Volume& volume) {
  ValueHistogram result{volume.range, {}};
  double& low = result.values.low;
  double width = volume.range.high / mostBins - volume.range.low / mostBins;  // a difference may overflow
  volume.voxels.visit([&](auto scalars) {
    if constexpr (std::is_integral_v<std::remove_const_t<typename decltype(scalars)::value_type>>) {
      const double quantum = std::abs(volume.slope);
      width = quantum * std::max(1.0, std::ceil(width / quantum));
      low -= 0.5 * quantum;  // whole numbers lie in the middle of their bins
    }
  });
  if (!(width > 0.0)) width = 1.0;
  const auto bins = static_cast<std::size_t>(std::floor(volume.range.high / width - low / width)) + 1;
  result.values.high = low + width * static_cast<double>(bins);
  result.counts.assign(bins, 0);
  return {std::move(result), width};
}

}  // namespace

double ValueHistogram::density(ValueRange range) const {
  if (counts.empty() || range.high < values.low || range.low > values.high) return 0.0;
  const double scale = static_cast<double>(counts.size()) / (values.high - values.low);
  const auto binAt = [&](double value) {
    const double bin = std::floor((value - values.low) * scale);
    return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(counts.size() - 1)));
  };
  const std::size_t first = binAt(range.low), last = binAt(range.high);
  double sum = 0.0;
  for (std::size_t bin = first; bin <= last; ++bin) sum += counts[bin];
  return sum / static_cast<double>(last - first + 1);
}

ValueHistogram histogramOf(const Volume& volume) {
  const Bins bins = binsOf(volume);
  ValueHistogram result = bins.empty;
  volume.voxels.visit([&](auto scalars) {
    // Odd, or with rows of a power of two it would sample the same columns over and over.
    const std::size_t stride = (scalars.size() >> 18) | 1;
    for (std::size_t i = 0; i < scalars.size(); i += stride)
      if (const std::size_t bin = bins.binOf(volume.slope * static_cast<double>(scalars[i]) + volume.intercept);
          bin < bins.count())
        ++result.counts[bin];
  });
  return result;
}

ValueHistogram histogramOf(const Volume& volume, const LabelMap& labels, std::uint16_t label) {
  const Bins bins = binsOf(volume);
  ValueHistogram result = bins.empty;
  std::mutex mutex;
  volume.voxels.visit([&](auto scalars) {
    labels.voxels.visit([&](auto marks) {
      parallelFor(scalars.size(), std::size_t{1} << 20, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> counts(bins.count());
        for (std::size_t i = begin; i < end; ++i) {
          if (static_cast<std::uint16_t>(marks[i]) != label) continue;
          const std::size_t bin = bins.binOf(volume.slope * static_cast<double>(scalars[i]) + volume.intercept);
          if (bin < bins.count()) ++counts[bin];
        }
        const std::scoped_lock lock(mutex);
        for (std::size_t bin = 0; bin < counts.size(); ++bin) result.counts[bin] += counts[bin];
      });
    });
  });
  return result;
}

ValueRange middleOf(const ValueHistogram& histogram, double share) {
  const auto& counts = histogram.counts;
  const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
  if (!(all > 0.0)) return histogram.values;
  const double width = (histogram.values.high - histogram.values.low) / static_cast<double>(counts.size());
  const auto valueAbove = [&](double wanted) {
    double sum = 0.0;
    for (std::size_t bin = 0; bin < counts.size(); ++bin) {
      if (counts[bin] > 0 && sum + counts[bin] >= wanted)
        return histogram.values.low + width * (static_cast<double>(bin) + (wanted - sum) / counts[bin]);
      sum += counts[bin];
    }
    return histogram.values.high;
  };
  return {valueAbove(share * all), valueAbove((1.0 - share) * all)};
}

}  // namespace fenestra::viewer
