#pragma once
// Values freed of noise, with edges kept.

#include <algorithm>
#include <limits>
#include <vector>

#include "rendering/scene/Volume.h"
#include "rendering/segmentation/VoxelBox.h"

namespace fenestra::segmentation {

/// Standard deviation of the noise in real values, from second differences along the rows: their median ignores edges,
/// which are few. Flat parts of the least value (padding) do not count. At least 2 %
/// of the display window, which is the least that the eye tells apart, so that volumes without noise have a unit too.
double noiseOf(const Volume& volume);

/// Values as the eye compares them, in units of the noise: 0 at a reference value, and limited to ±256, beyond which
/// nothing is told apart. In Hounsfield units, differences beyond the display window count less, because the picture
/// shows them as black or white: marrow and the brighter cortex around it are one bone, a lung and its vessels one
/// lung.
class ToneScale {
 public:
  /// `noise` and `reference` in real values.
  ToneScale(const Volume& volume, double noise, double reference);
  double operator()(double real) const { return std::clamp((toned(real) - reference_) / noise_, -farthest, farthest); }

 private:
  static constexpr double beyondWindow = 0.3;  ///< share of a difference that counts there
  static constexpr double farthest = 256.0;
  double toned(double real) const {
    const double seen = std::clamp(real, seen_.low, seen_.high);
    return seen + beyondWindow * (real - seen);
  }
  double noise_, reference_ = 0.0;
  ValueRange seen_{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};
};

/// Tones of `box`, smoothed by the guided filter with the volume as its own guide, on 3×3×3 voxels: He, Sun, Tang,
/// "Guided Image Filtering", ECCV 2010, eqs. 5, 6 and 8. Where the variance is the noise's the result is nearly the
/// mean; at edges it is the value. Neighbours outside the box are read too, so that the result does not depend on the
/// box. `box` lies in the volume. NaN counts as the volume's least value, ±Inf as the ends of its range.
std::vector<float> smoothedTones(const Volume& volume, const VoxelBox& box, const ToneScale& scale);

}  // namespace fenestra::segmentation
