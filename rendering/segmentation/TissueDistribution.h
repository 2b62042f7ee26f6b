#pragma once
// How the values of a volume are spread in what is not background.

#include <cstddef>
#include <vector>

#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// The real values of what is not background, from evenly spaced voxels. A volume without finite values has none; all
/// measures of it are 0.
class TissueDistribution {
 public:
  enum class Background {
    /// What lies below the threshold that separates the two classes best (Otsu, IEEE Trans. SMC 9(1), 1979: the
    /// greatest variance between classes). Dark tissue, as skin and muscle in many MR, counts as background with air.
    DarkerClass,
    /// Air and its noise: where the darker class falls into two that are told apart well, the darker one of them.
    Air,
  };
  explicit TissueDistribution(const Volume& volume, Background background = Background::DarkerClass);

  /// The real value at a percentile, 0 … 100. With Background::Air, 0 is half-way between the brightest background and
  /// the darkest tissue, where the surface lies.
  double at(double percentile) const;
  double mean() const;
  /// Share of the values that are greater, 0 … 1.
  double shareAbove(double value) const;

 private:
  std::vector<double> values_;  ///< ascending
};

}  // namespace fenestra::segmentation
