#pragma once
// The region around a click that a random walk hardly leaves: for what no border encloses.
//
// Where a structure's border is as faint as the noise, and missing in places, a tolerance and a merge of tissues pass
// through its gaps. A random walk does so seldom, because gaps are few among the many faces of a border (L. Grady:
// Random walks for image segmentation, IEEE Transactions on Pattern Analysis and Machine Intelligence 28(11), 2006).
// Walkers step from voxel to voxel, the less often the more the two differ, until they meet a small ball around a seed
// or a sphere around the click. The probability that a walker from a voxel ends at the ball is 1 at the click and 0 at
// the sphere, and falls most across borders. Its level sets are nested and connected. The one across whose surface the
// values differ most, and which is most compact, is the region. Seeds inside are further balls, and seeds outside
// further ends.

#include <optional>
#include <span>
#include <vector>

#include "rendering/segmentation/Levels.h"
#include "rendering/segmentation/Smoothing.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

struct WalkRegion {
  VoxelBox box;              ///< clipped to the volume
  std::vector<Level> joins;  ///< by voxel of the box: the less likely a walker ends at a seed, the higher
  int step = 0;              ///< of the clearest level set
  double contrast = 0.0;     ///< mean difference across its surface, units of the noise
  double compactness = 0.0;  ///< as GrowthCurve::compactness
  double support = 0.0;      ///< share of its surface across which values differ by more than the noise
};

/// mm³: other level sets are no region.
struct WalkBounds {
  double least = 500.0;
  double most = 17157.0;  ///< a ball of half the sphere's radius: the sphere bounds what is larger
};

/// `inside` has one seed at least. The sphere is around the first one; other seeds count where they lie in it. Empty
/// where no level set stands out. Takes some 40 bytes a voxel of the sphere's box. Deterministic. Runs on all cores.
std::optional<WalkRegion> walkRegion(const Volume& volume, const Noise& noise, std::span<const glm::ivec3> inside,
                                     std::span<const glm::ivec3> outside, const WalkBounds& bounds = {});

}  // namespace fenestra::segmentation
