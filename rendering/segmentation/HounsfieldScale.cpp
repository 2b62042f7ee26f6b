#include "rendering/segmentation/HounsfieldScale.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "rendering/segmentation/TissueDistribution.h"

namespace fenestra::segmentation {
namespace {

/// MR may have the narrow peak of soft tissue by chance, but hardly any of it is nearly twice as bright as that, as
/// compact bone is in CT: in the heads of the test data, 10 % and more.
constexpr double compactBone = 776.0;       ///< HU
constexpr double leastCompactBone = 0.004;  ///< of the body's voxels

/// Whether a volume of no known kind has the values of CT plus 1024, as scanners store them and some converters leave
/// them. The scale is known then, so that less is asked of the values than of a guess, which foam around a head fails.
bool isStoredCt(const Volume& volume) {
  constexpr double airBelow = -900.0, tissueAbove = -500.0;            // HU
  constexpr double peakLow = -20.0, peakHigh = 90.0, peakHalf = 60.0;  // HU: muscle, brain and organs
  constexpr int stored = 1024, most = 4096;
  if (volume.modality != Modality::Unknown && volume.modality != Modality::CT) return false;
  if (volume.range.low < 0.0 || volume.range.low > stored + airBelow || volume.range.high >= most) return false;
  std::vector<double> counts(most, 0.0);
  volume.voxels.visit([&](auto scalars) {
    const std::size_t stride = scalars.size() >> 20 | 1;
    for (std::size_t i = 0; i < scalars.size(); i += stride) {
      const double real = volume.slope * static_cast<double>(scalars[i]) + volume.intercept;
      if (real >= 0.0 && real < most) ++counts[static_cast<std::size_t>(real)];
    }
  });
  const auto between = [&](double low, double high) {
    const auto at = [&](double hounsfield) {
      return counts.begin() + static_cast<std::ptrdiff_t>(std::clamp(hounsfield + stored, 0.0, double(most)));
    };
    return std::accumulate(at(low), at(high), 0.0);
  };
  // The peak of a window that is as wide as scanners' noise.
  constexpr double step = 10.0, half = 15.0;
  double peak = tissueAbove, height = 0.0;
  for (double middle = tissueAbove; middle + half < most - stored; middle += step)
    if (const double here = between(middle - half, middle + half); here > height) {
      height = here;
      peak = middle;
    }
  const double body = between(tissueAbove, most);
  return peak >= peakLow && peak <= peakHigh && between(peak - peakHalf, peak + peakHalf) >= 0.25 * body &&
         between(compactBone, most) >= leastCompactBone * body &&
         between(-stored, airBelow) >= 0.02 * (body + between(-stored, tissueAbove));
}

}  // namespace

std::optional<HounsfieldScale> hounsfieldScaleOf(const Volume& volume) {
  if (volume.isInHounsfieldUnits()) return std::nullopt;
  if (isStoredCt(volume)) return HounsfieldScale{1.0, -1024.0};
  const auto guess = hounsfieldGuess(volume);
  if (!guess) return std::nullopt;
  const bool isKnownCt = volume.modality == Modality::CT;
  if (!isKnownCt && TissueDistribution(volume).shareAbove(guess->realAt(compactBone)) < leastCompactBone)
    return std::nullopt;
  return guess;
}

}  // namespace fenestra::segmentation
