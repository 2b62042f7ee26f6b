#pragma once
// How a region hangs together, seen so coarsely that no grain of its surface counts.

#include <span>

#include "rendering/segmentation/Levels.h"
#include "rendering/volume/Grid.h"

namespace fenestra::segmentation {

struct RegionShape {
  /// The greatest depth of the region over that of the part which holds the seed: 1 where it is the deepest part, more
  /// where the region goes on from a thin part into a thicker one.
  double thickening = 1.0;
  double compactness = 1.0;  ///< as GrowthCurve::compactness, of the cells
};

/// The shape of the voxels with `joins` < `step`, which are `volume` mm³. `joins` are of all voxels of the grid. The
/// part of a seed beside the region is that of the nearest cell. Cells are the coarser, the larger the region is, so
/// that it takes some 20 ms of any; finding it in the volume takes longer. On all cores.
RegionShape shapeOf(const Grid& grid, std::span<const Level> joins, int step, double volume, glm::ivec3 seed);

}  // namespace fenestra::segmentation
