#pragma once
// Grey-value morphology of levels with balls, which acts on the regions of all tolerances at once.

#include <span>
#include <vector>

#include "rendering/segmentation/Levels.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Grid.h"

namespace fenestra::segmentation {

/// Index offsets within `radius` mm of a voxel, the voxel itself among them; distances are the world's, so sheared and
/// anisotropic grids have round balls.
std::vector<glm::ivec3> ballOffsets(const Grid& grid, double radius);

struct BallOffset {
  glm::ivec3 step{0};
  double length = 0.0;  ///< mm
};
/// Those of ballOffsets(), the nearest first.
std::vector<BallOffset> nearestFirst(const Grid& grid, double radius);

/// The side in mm of a cube with the volume of a voxel: the unit of radii that leaks of noise are measured in.
double voxelSide(const Grid& grid);

/// Greatest level within the ball around each voxel of a box of `dims`; what lies outside the box does not count. A
/// region {level ≤ T} shrinks by the ball. Runs on all cores.
std::vector<Level> greatestWithin(std::span<const Level> levels, glm::ivec3 dims,
                                  const std::vector<glm::ivec3>& offsets);
/// Writes the least level within the ball around each voxel into `to` where that is less. Regions grow by the ball.
void lowerToLeastWithin(std::span<const Level> levels, glm::ivec3 dims, const std::vector<glm::ivec3>& offsets,
                        std::span<Level> to);

}  // namespace fenestra::segmentation
