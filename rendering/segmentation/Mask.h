#pragma once
// One region as a mask, and how it is edited.

#include <cstdint>
#include <memory>
#include <vector>

#include "rendering/segmentation/RegionGrowing.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/LabelMap.h"

namespace fenestra::segmentation {

/// Voxels of a grid: 1 inside, 0 outside, x fastest.
struct Mask {
  Grid grid;
  std::vector<std::uint8_t> voxels;
};

/// The region of `growth` at a step.
Mask maskAt(const Growth& growth, int step);
/// Sets a mask of another step to the region of `growth` at `step`. Uses its memory again, so that a slider allocates
/// none.
void setMask(Mask& mask, const Growth& growth, int step);
/// The voxels of `labels` that have the value `label`.
Mask maskOf(const LabelMap& labels, std::uint16_t label);
/// A label map of one label.
std::shared_ptr<const LabelMap> labelMapOf(const Mask& mask, const Label& label);
/// The labels in the focus of a scene as one label; the scene has labels in its focus.
std::shared_ptr<const LabelMap> focusLabel(const Scene& scene, const Label& label);

/// The least box that holds the mask; empty without voxels.
VoxelBox boundsOf(const Mask& mask);
/// mm³.
double volumeOf(const Mask& mask);

/// Adds the voxels whose centre lies within `distance` mm of a voxel's centre in the mask.
Mask grown(const Mask& mask, double distance);
/// Removes the voxels whose centre lies within `distance` mm of the centre of one outside the mask. The volume's border
/// is no outside: a structure that the scan cuts stays cut there.
Mask shrunk(const Mask& mask, double distance);
/// Adds the voxels outside that are cut off from the volume's border, over faces.
Mask withHolesFilled(const Mask& mask);
/// Removes the 26-connected parts smaller than `leastVolume` mm³.
Mask withoutIslands(const Mask& mask, double leastVolume);
/// The largest 26-connected part alone; among equal ones the first in memory.
Mask largestPart(const Mask& mask);

}  // namespace fenestra::segmentation
