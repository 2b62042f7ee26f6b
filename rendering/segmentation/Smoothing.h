#pragma once
// Values freed of noise, with edges kept.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// The real value of a stored one. NaN counts as the volume's least value, ±Inf as the ends of its range.
template <class T>
double finiteValue(T stored, const Volume& volume) {
  const double real = volume.slope * static_cast<double>(stored) + volume.intercept;
  if constexpr (std::is_floating_point_v<T>)
    return std::isnan(real) ? volume.range.low : std::clamp(real, volume.range.low, volume.range.high);
  return real;
}

/// In real values.
struct Noise {
  double deviation = 0.0;  ///< standard deviation of the noise
  /// The unit of costs and tolerances: the deviation, but at least 2 % of the display window, which is the least that
  /// the eye tells apart.
  double unit = 1.0;
  double seen = 1.0;  ///< the least difference that the eye tells apart

  double share() const { return deviation / unit; }
  bool operator==(const Noise&) const = default;
};

/// The noise from second differences along the rows: their median ignores edges, which are few. Flat parts of the
/// least value (padding) do not count.
Noise noiseOf(const Volume& volume);

inline constexpr double softTissue = 40.0;  ///< HU: the reference of tones in CT

/// Values as the eye compares them, in units of Noise::unit: 0 at a reference value, and limited to ±256, beyond which
/// nothing is told apart. In Hounsfield units, differences beyond the display window count less, because the picture
/// shows them as black or white: marrow and the brighter cortex around it are one bone, a lung and its vessels one
/// lung.
class ToneScale {
 public:
  /// `reference` is a real value.
  ToneScale(const Volume& volume, const Noise& noise, double reference);
  double operator()(double real) const {
    return std::clamp((toned(real) - reference_) / noise_.unit, -farthest, farthest);
  }
  /// The real value of a tone, in the same units.
  float linear(float tone) const {
    const float seen = std::clamp(tone, seenTones_[0], seenTones_[1]);
    return seen + static_cast<float>(1.0 / beyondWindow) * (tone - seen);
  }
  const Noise& noise() const { return noise_; }

 private:
  static constexpr double beyondWindow = 0.3;  ///< share of a difference that counts there
  static constexpr double farthest = 256.0;
  double toned(double real) const {
    const double seen = std::clamp(real, seen_.low, seen_.high);
    return seen + beyondWindow * (real - seen);
  }
  Noise noise_;
  double reference_ = 0.0;
  std::array<float, 2> seenTones_{};  ///< of the window's ends
  ValueRange seen_{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};
};

/// Tones, smoothed by the guided filter with the volume as its own guide, on 3×3×3 voxels: He, Sun, Tang, "Guided Image
/// Filtering", ECCV 2010, eqs. 5, 6 and 8. Where the variance is the noise's the result is nearly the mean; at edges it
/// is the value. Neighbours outside a box are read too, so that the result does not depend on the box. Beyond the
/// volume its edge is repeated; other values are those of finiteValue().
class ToneSmoother {
 public:
  /// Both outlive this.
  ToneSmoother(const Volume& volume, const ToneScale& scale) : volume_(volume), scale_(scale) {}

  /// The tones of `box`, x fastest, until the next call: boxes of one size share their memory.
  std::span<const float> operator()(const VoxelBox& box);

 private:
  const Volume& volume_;
  const ToneScale& scale_;
  std::vector<float> values_, sums_, slope_, intercept_, smoothed_;
};

/// Tones of one box, see ToneSmoother.
std::vector<float> smoothedTones(const Volume& volume, const VoxelBox& box, const ToneScale& scale);

}  // namespace fenestra::segmentation
