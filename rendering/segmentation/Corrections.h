#pragma once
// A click's region as further seeds change it.

#include <span>
#include <vector>

#include "rendering/segmentation/Competition.h"

namespace fenestra::segmentation {

struct CorrectedRegion {
  std::vector<Level> joins;  ///< of the volume's voxels
  GrowthCurve curve;
};

/// Adds what the further seeds of `inside` mean, and takes away what those `outside` do; the first of `inside` is the
/// region's own. The step with which the region begins stays.
CorrectedRegion corrected(const Volume& volume, const Competition& competition, const FirstRegion& first,
                          std::span<const glm::ivec3> inside, std::span<const glm::ivec3> outside);

}  // namespace fenestra::segmentation
