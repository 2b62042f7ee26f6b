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
/// region's own. The step with which the region begins stays, but in a leak.
///
/// A walk's region walks again, with all seeds as its ends, unless one lies too far away for it.
///
/// Where the first region is large enough for a leak, seeds outside are looked at first. One that lies in a far thicker
/// part than the first seed takes away all up to the narrow place between. One in a part as thick, nearer to its middle
/// than to its surface, leaves nothing for the shape to part, and so does any where the region lacks the first seed's
/// own voxel, as it may on a border. The first seed's region is then the clearest one that holds no such seed, as
/// markers part a tree of merges (P. Salembier, L. Garrido: Binary partition tree as an efficient representation for
/// image processing, segmentation, and information retrieval, IEEE Transactions on Image Processing 9(4), 2000). What
/// is left then is corrected in the same way, until it holds no deep seed.
CorrectedRegion corrected(const Volume& volume, const Competition& competition, const FirstRegion& first,
                          std::span<const glm::ivec3> inside, std::span<const glm::ivec3> outside);

}  // namespace fenestra::segmentation
