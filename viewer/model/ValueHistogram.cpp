#include "viewer/model/ValueHistogram.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace fenestra::viewer {
namespace {

constexpr double mostBins = 4096.0;  ///< a plot of 250 pixels can be enlarged sixteen times

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
  ValueHistogram result{volume.range, {}};
  volume.voxels.visit([&](auto scalars) {
    using Scalar = typename decltype(scalars)::value_type;
    double& low = result.values.low;
    double width = volume.range.high / mostBins - volume.range.low / mostBins;  // a difference may overflow
    if constexpr (std::is_integral_v<std::remove_const_t<Scalar>>) {
      const double quantum = std::abs(volume.slope);
      width = quantum * std::max(1.0, std::ceil(width / quantum));
      low -= 0.5 * quantum;  // whole numbers lie in the middle of their bins
    }
    if (!(width > 0.0)) width = 1.0;
    const auto bins = static_cast<std::size_t>(std::floor(volume.range.high / width - low / width)) + 1;
    result.values.high = low + width * static_cast<double>(bins);
    result.counts.assign(bins, 0);
    // An odd stride does not fall into step with rows whose length is a power of two.
    const std::size_t stride = (scalars.size() >> 18) | 1;
    for (std::size_t i = 0; i < scalars.size(); i += stride) {
      const double bin = std::floor((volume.slope * static_cast<double>(scalars[i]) + volume.intercept - low) / width);
      if (bin >= 0.0 && bin < static_cast<double>(bins)) ++result.counts[static_cast<std::size_t>(bin)];
    }
  });
  return result;
}

}  // namespace fenestra::viewer
