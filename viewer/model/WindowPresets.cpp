#include "viewer/model/WindowPresets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace fenestra::viewer {

WindowLevel windowOfPercentiles(const Volume& volume, double lowShare, double highShare) {
  constexpr std::size_t enough = std::size_t{1} << 20;
  std::vector<double> values;
  volume.voxels.visit([&](auto scalars) {
    // An odd step, so that a row's length and it seldom have a common factor.
    const std::size_t step = scalars.size() / enough | 1;
    for (std::size_t i = 0; i < scalars.size(); i += step) {
      const double value = volume.slope * static_cast<double>(scalars[i]) + volume.intercept;
      if (std::isfinite(value)) values.push_back(value);
    }
  });
  if (values.empty()) return {};
  const auto percentile = [&values](double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
  };
  const double low = percentile(lowShare), high = percentile(highShare);
  return {high > low ? high - low : 1.0, 0.5 * (low + high)};
}

}  // namespace fenestra::viewer
