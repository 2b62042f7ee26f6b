#pragma once
// Strokes of a ball brush that add voxels to a region or take them away (SelectionStroke in
// rendering/settings/Focus.h).

#include <span>
#include <vector>

#include "rendering/segmentation/VoxelBox.h"
#include "rendering/settings/Focus.h"

namespace fenestra::segmentation {

/// The voxels whose centres a stroke's balls may hold, within the grid.
VoxelBox boxOf(const SelectionStroke& stroke, const Grid& grid);

/// The voxels of a stroke, as offsets into the grid, ascending. With d the distance in mm of a voxel's centre from the
/// nearest point of the polyline of anchors, and c = (1 - softness) · radius, all voxels with d ≤ c belong to it. In
/// the soft rim, c < d < radius, a voxel belongs to it if its value v is like those within c, whose mean is v̄:
///
///   |v - v̄| · (d - c) ≤ alike · noise · (radius - d)
///
/// the more like them, the farther out; `noise` is Noise::unit (real values). Where no voxel lies within c, v̄ is the
/// value of the voxel nearest to the polyline. A value that is not a number is like none.
inline constexpr double alike = 3.0;
std::vector<std::size_t> voxelsOf(const SelectionStroke& stroke, const Volume& volume, double noise);

/// Turns `steps` (as Growth::steps has them, on the volume's grid) into those of the painted region: voxels that a
/// stroke adds belong to every step, those that it takes to none; stroke by stroke. `countOf`, one entry a step from 0
/// on, follows: the voxels that each step holds.
void paint(std::span<std::uint8_t> steps, std::span<double> countOf, const Volume& volume, double noise,
           std::span<const SelectionStroke> strokes);

}  // namespace fenestra::segmentation
