#pragma once
// Regions that tests make by a rule.

#include <vector>

#include "rendering/segmentation/RegionBalls.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests {

/// The levels of a region that joins at level 0 where `isIn`.
template <class IsIn>
std::vector<segmentation::Level> regionOf(const Grid& grid, IsIn isIn) {
  std::vector<segmentation::Level> joins(grid.voxelCount(), segmentation::never);
  forEachVoxel(grid.dims, [&](glm::ivec3 at) {
    if (isIn(at)) joins[grid.offset(at)] = 0;
  });
  return joins;
}

}  // namespace fenestra::tests
