#include "rendering/volume/Volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "rendering/volume/Threads.h"

namespace fenestra {

double Volume::value(glm::ivec3 index) const {
  const double stored = voxels.visit([&](auto scalars) { return static_cast<double>(scalars[grid.offset(index)]); });
  return slope * stored + intercept;
}

double Volume::sample(glm::dvec3 index) const {
  return interpolated(grid, index, [&](glm::ivec3 voxel) { return value(voxel); });
}

void Volume::computeRange() {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::mutex mutex;
  voxels.visit([&](auto scalars) {
    parallelFor(scalars.size(), 1 << 20, [&](std::size_t begin, std::size_t end) {
      using T = typename decltype(scalars)::value_type;
      T least = std::numeric_limits<T>::max(), greatest = std::numeric_limits<T>::lowest();
      bool any = false;
      for (std::size_t i = begin; i < end; ++i) {
        const T scalar = scalars[i];
        if constexpr (std::is_floating_point_v<T>)
          if (!std::isfinite(scalar)) continue;
        least = std::min(least, scalar);
        greatest = std::max(greatest, scalar);
        any = true;
      }
      if (!any) return;
      const std::scoped_lock lock(mutex);
      low = std::min(low, static_cast<double>(least));
      high = std::max(high, static_cast<double>(greatest));
    });
  });
  if (low > high) {
    range = {};
    return;
  }
  const double a = slope * low + intercept, b = slope * high + intercept;
  range = {std::min(a, b), std::max(a, b)};
}

bool Volume::isInHounsfieldUnits() const {
  if (modality != Modality::CT && modality != Modality::Unknown) return false;
  const bool spansAirAndBone = range.low <= -300.0 && range.low >= -10000.0 && range.high >= 150.0;
  return (unit == "HU" && range.low < 0.0) || spansAirAndBone;
}

bool looksLikeCt(const Volume& volume) {
  if (!volume.isInHounsfieldUnits()) return false;
  std::size_t total = 0, air = 0, soft = 0, lung = 0, impossible = 0;
  volume.voxels.visit([&](auto scalars) {
    // A million voxels tell shares of a thousandth.
    const std::size_t stride = std::max<std::size_t>(1, scalars.size() >> 20);
    for (std::size_t i = 0; i < scalars.size(); i += stride) {
      const double hu = volume.slope * static_cast<double>(scalars[i]) + volume.intercept;
      ++total;
      // The least value stands for what was not scanned, whatever it is.
      air += (hu >= -1100.0 && hu <= -900.0) || hu == volume.range.low;
      soft += hu >= -150.0 && hu <= 150.0;
      lung += hu >= -600.0 && hu <= -300.0;
      impossible += !(hu >= -1100.0 && hu <= 4100.0) && hu != volume.range.low;
    }
  });
  const auto share = [&](std::size_t count) { return static_cast<double>(count) / static_cast<double>(total); };
  // Between air and soft tissue lie only lung and edges, 300 HU wide as soft tissue here: where values are spread
  // evenly, as much falls there. Interpolation rings a little below air.
  return share(air) > 0.001 && share(soft) > 0.02 && soft > 2 * lung && share(impossible) < 0.01;
}

WindowLevel Volume::defaultWindow() const {
  if (!windows.empty()) return windows.front();
  if (isInHounsfieldUnits()) return {400.0, 40.0};  // soft tissue, what CT is read with first
  if (!(range.high > range.low)) return {1.0, range.low};
  // About a million voxels are enough for two percentiles.
  constexpr std::size_t bins = 1024;
  std::vector<std::size_t> histogram(bins, 0);
  std::size_t total = 0;
  voxels.visit([&](auto scalars) {
    const std::size_t stride = std::max<std::size_t>(1, scalars.size() >> 20);
    for (std::size_t i = 0; i < scalars.size(); i += stride) {
      const double real = slope * static_cast<double>(scalars[i]) + intercept;
      if (!std::isfinite(real)) continue;
      const double position = (real - range.low) / (range.high - range.low) * bins;
      ++histogram[std::min(bins - 1, static_cast<std::size_t>(std::max(0.0, position)))];
      ++total;
    }
  });
  const auto percentile = [&](double fraction) {
    const double wanted = fraction * static_cast<double>(total);
    double seen = 0.0;
    for (std::size_t bin = 0; bin < bins; ++bin) {
      seen += static_cast<double>(histogram[bin]);
      if (seen >= wanted) return range.low + (range.high - range.low) * (static_cast<double>(bin) + 0.5) / bins;
    }
    return range.high;
  };
  const double low = percentile(0.01), high = percentile(0.99);
  if (!(high > low)) return {range.high - range.low, 0.5 * (range.low + range.high)};
  return {high - low, 0.5 * (low + high)};
}

}  // namespace fenestra
