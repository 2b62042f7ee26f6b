#include "rendering/segmentation/HounsfieldGuess.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <vector>

namespace fenestra::segmentation {
namespace {

constexpr double softPeak = 45.0;                              ///< HU: muscle, brain and organs lie between 25 and 70
constexpr double fatPeak = -100.0;                             ///< HU
constexpr double softHalf = 60.0;                              ///< HU: half the width of the peak with noise
constexpr double fatBelowLeast = 100.0, fatBelowMost = 190.0;  ///< HU: from the peak of fat to that of soft tissue
constexpr double bodyAbove = -500.0, boneAbove = 250.0, boneBelow = 3500.0;  ///< HU
constexpr double lowestShare = 0.15;  ///< of the range of values: the peak of air is darker, that of soft tissue not
constexpr double leastAir = 0.02, leastBone = 0.004, mostBone = 0.5;  ///< of all voxels, and of the body's

/// Least share at the peak of soft tissue, greatest height of the valley. The head of MRIcroGL has 0.6 and 0.02, the
/// torso of TotalSegmentator 0.4 and 0.1; T1 of Colin 27 has 0.2 and 0.4.
struct Limits {
  double soft, valley;
};
constexpr Limits ofCt{0.25, 0.35}, ofUnknown{0.35, 0.2};

/// The counts of values from the least to a high one, smoothed; each bin is no narrower than a step of stored integers.
struct Histogram {
  double low = 0.0, width = 1.0;  ///< real values: of the first bin's begin, of a bin
  std::vector<double> counts;
  double total = 0.0;

  explicit Histogram(const Volume& volume) {
    std::vector<double> values;
    volume.voxels.visit([&](auto scalars) {
      const std::size_t stride = std::max<std::size_t>(1, scalars.size() >> 20);
      for (std::size_t i = 0; i < scalars.size(); i += stride)
        if (const double real = volume.slope * static_cast<double>(scalars[i]) + volume.intercept; std::isfinite(real))
          values.push_back(real);
    });
    if (values.size() < 1000) return;
    // Metal is brighter than all bone.
    const auto high = values.begin() + static_cast<std::ptrdiff_t>(0.9995 * static_cast<double>(values.size()));
    std::nth_element(values.begin(), high, values.end());
    low = volume.range.low;
    const bool isInteger = volume.voxels.type() != ScalarType::Float32 && volume.voxels.type() != ScalarType::Float64;
    const double step = isInteger ? std::abs(volume.slope) : 0.0;
    width = std::max((*high - low) / 256.0, step);
    if (!(width > 0.0) || !(*high > low)) return;
    counts.assign(static_cast<std::size_t>((*high - low) / width) + 1, 0.0);
    total = static_cast<double>(values.size());
    for (const double value : values)
      if (const auto bin = static_cast<std::size_t>((value - low) / width + 1e-6); bin < counts.size()) ++counts[bin];
  }

  double valueAt(std::size_t bin) const { return low + (static_cast<double>(bin) + 0.5) * width; }
  /// Voxels with values in [from, to].
  double between(double from, double to) const {
    double sum = 0.0;
    for (std::size_t bin = 0; bin < counts.size(); ++bin)
      if (valueAt(bin) >= from && valueAt(bin) <= to) sum += counts[bin];
    return sum;
  }
  std::size_t peakIn(std::size_t from, std::size_t to) const {
    const auto begin = counts.begin() + static_cast<std::ptrdiff_t>(from);
    return static_cast<std::size_t>(
        std::max_element(begin, counts.begin() + static_cast<std::ptrdiff_t>(std::max(from + 1, to))) - counts.begin());
  }
};

/// The scale of which the peaks of air and soft tissue are those of two bins.
HounsfieldGuess scaleOf(const Histogram& values, std::size_t air, std::size_t soft) {
  HounsfieldGuess guess;
  guess.factor = (softPeak - airValue) / (values.valueAt(soft) - values.valueAt(air));
  guess.offset = airValue - guess.factor * values.valueAt(air);
  return guess;
}

}  // namespace

std::optional<HounsfieldGuess> hounsfieldGuess(const Volume& volume) {
  const bool isCt = volume.modality == Modality::CT;
  if (volume.isInHounsfieldUnits() || (!isCt && volume.modality != Modality::Unknown)) return std::nullopt;
  const Histogram values(volume);
  const std::size_t bins = values.counts.size();
  const auto lowest = static_cast<std::size_t>(lowestShare * static_cast<double>(bins));
  if (lowest < 2) return std::nullopt;
  const std::size_t air = values.peakIn(0, lowest);
  const std::size_t soft = values.peakIn(lowest, bins);
  HounsfieldGuess guess = scaleOf(values, air, soft);
  // Where fat is most of the body, its peak is the highest.
  bool isFat = false;
  const auto binsOf = [&](double hounsfield) {
    return static_cast<std::size_t>(std::lround(hounsfield / (guess.factor * values.width)));
  };
  const std::size_t from = soft + binsOf(fatBelowLeast), to = std::min(bins, soft + binsOf(fatBelowMost));
  if (from + 1 < to) {
    const std::size_t next = values.peakIn(from, to);
    const std::size_t valley = (soft + next) / 2;
    if (next > from && next + 1 < to && values.counts[next] > 0.2 * values.counts[soft] &&
        values.counts[next] > 1.5 * values.counts[valley]) {
      guess = scaleOf(values, air, next);
      isFat = true;
    }
  }
  const double body = values.between(guess.realAt(bodyAbove), guess.realAt(boneBelow));
  const double nearAir = values.between(values.low, guess.realAt(airValue + 150.0));
  if (body <= 0.0 || nearAir < leastAir * values.total) return std::nullopt;
  guess.soft =
      values.between(guess.realAt((isFat ? fatPeak : softPeak) - softHalf), guess.realAt(softPeak + softHalf)) / body;
  // A mean over as many values as the peak's.
  guess.valley = values.between(guess.realAt(-500.0 - softHalf), guess.realAt(-500.0 + softHalf)) / (guess.soft * body);
  guess.bone = values.between(guess.realAt(boneAbove), guess.realAt(boneBelow)) / body;
  const Limits limits = isCt ? ofCt : ofUnknown;
  const bool isSpreadAsInCt =
      guess.soft >= limits.soft && guess.valley <= limits.valley && guess.bone >= leastBone && guess.bone <= mostBone;
  return isSpreadAsInCt ? std::optional(guess) : std::nullopt;
}

std::shared_ptr<const Volume> inHounsfieldUnits(const Volume& volume, const HounsfieldGuess& guess,
                                                const VoxelBox& box) {
  auto scaled = std::make_shared<Volume>();
  scaled->grid = volume.grid;
  scaled->grid.dims = box.dims();
  scaled->grid.origin = glm::dvec3(volume.grid.worldFromIndex() * glm::dvec4(glm::dvec3(box.low), 1.0));
  scaled->voxels = Voxels(volume.voxels.type(), box.count());
  const std::size_t each = sizeOf(volume.voxels.type()), row = static_cast<std::size_t>(box.dims().x) * each;
  std::byte* to = scaled->voxels.data();
  for (int z = box.low.z; z < box.high.z; ++z)
    for (int y = box.low.y; y < box.high.y; ++y, to += row)
      std::memcpy(to, volume.voxels.data() + volume.grid.offset({box.low.x, y, z}) * each, row);
  scaled->slope = guess.factor * volume.slope;
  scaled->intercept = guess.factor * volume.intercept + guess.offset;
  scaled->range = {guess.factor * volume.range.low + guess.offset, guess.factor * volume.range.high + guess.offset};
  scaled->range.low = std::min(scaled->range.low, airValue);
  scaled->modality = Modality::CT;
  scaled->unit = "HU";
  return scaled;
}

}  // namespace fenestra::segmentation
