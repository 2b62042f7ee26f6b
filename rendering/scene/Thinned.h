#pragma once
// Volumes and label maps with fewer voxels, for devices that the whole does not fit into.

#include <memory>

#include "rendering/scene/ShownVolume.h"
#include "rendering/volume/LabelMap.h"

namespace fenestra {

/// The grid whose voxels are blocks of `factor` voxels each, from the first voxel on; a block at the far end may reach
/// beyond it.
Grid thinned(const Grid& grid, glm::ivec3 factor);
/// Each voxel is the mean of its block's finite voxels in the same type, integers rounded; NaN where there is none. The
/// range stays that of the volume, which lighting refers to. What is hidden counts as the air that is shown.
std::shared_ptr<const Volume> thinned(const ShownVolume& shown, glm::ivec3 factor);
/// Each voxel has the label of the voxel in the middle of its block.
std::shared_ptr<const LabelMap> thinned(const LabelMap& labels, glm::ivec3 factor);

}  // namespace fenestra
