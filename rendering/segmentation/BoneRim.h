#pragma once
// Where a bone ends between voxels: what its rim holds less than half of is no bone.

#include <cstddef>
#include <span>
#include <vector>

#include "rendering/segmentation/Levels.h"
#include "rendering/segmentation/Smoothing.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

struct RimVoxel {
  std::size_t offset = 0;  ///< in the volume
  Level cost = 0;          ///< boneCosts() of what lies beyond, which the voxel holds more of
};

/// The voxels at the surface of the region of `joins` at `step` whose value is nearer to that of the soft tissue beside
/// them than to that of the dense bone behind them, as means within two voxels. A voxel that holds a tenth of cortical
/// bone is as dense as spongy bone. Where a bone is too thin to have a voxel behind its surface, none. `volume` is in
/// Hounsfield units, `joins` are of all its voxels.
std::vector<RimVoxel> softRim(const Volume& volume, const Noise& noise, std::span<const Level> joins, int step);

}  // namespace fenestra::segmentation
