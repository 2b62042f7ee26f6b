#pragma once
// What the voxels of each label measure: volume, values, place.

#include <cstdint>
#include <vector>

#include "rendering/volume/LabelMap.h"
#include "rendering/volume/Volume.h"

namespace fenestra {

struct LabelStatistics {
  std::uint16_t label = 0;
  std::size_t voxels = 0;
  double millilitres = 0.0;
  std::size_t valued = 0;  ///< voxels with a finite value, which alone count in what follows
  double mean = 0.0;       ///< real values; 0 where none is finite
  double deviation = 0.0;  ///< of the sample, with valued - 1; 0 for one value
  double least = 0.0, greatest = 0.0;
  /// World (LPS), mm: corners of the box along the patient's axes around whole voxels, and the mean of their centres.
  /// Meaningless without voxels.
  glm::dvec3 low{0.0}, high{0.0}, centre{0.0};
};

/// One element for each of `labels.labels`, in their order. Both are on one grid. Reads all voxels once, on all cores;
/// sums are kept by run of equal labels and merged by the formulas of Chan, Golub and LeVeque (1983), so that values
/// far from zero lose no digits.
std::vector<LabelStatistics> labelStatistics(const LabelMap& labels, const Volume& volume);

/// For each of labelStatistics(), the centre of the label's voxel that lies nearest to `centre`, world (LPS) mm: the
/// centre of a bent structure may lie outside of it. Of equally near ones the first in the map's order; meaningless
/// without voxels. Reads the labels once, on all cores.
std::vector<glm::dvec3> placesWithin(const LabelMap& labels, const std::vector<LabelStatistics>& statistics);

}  // namespace fenestra
