#pragma once
// How the values of a volume are spread in what is not background.

#include <cstddef>
#include <vector>

#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// The real values of what is not background, from evenly spaced voxels. Background is air and its noise: what lies
/// below the threshold that separates the two classes best (Otsu, IEEE Trans. SMC 9(1), 1979: the greatest variance
/// between classes). A volume without finite values has none; all measures of it are 0.
class TissueDistribution {
 public:
  explicit TissueDistribution(const Volume& volume);

  /// The real value at a percentile, 0 … 100.
  double at(double percentile) const;
  double mean() const;
  /// Share of the values that are greater, 0 … 1.
  double shareAbove(double value) const;

 private:
  std::vector<double> values_;  ///< ascending
};

}  // namespace fenestra::segmentation
