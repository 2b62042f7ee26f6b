// Cells of the voxels' grid as blocks of the finer grid that a spline is walked on (lib/grid/Refined.glsl).
#include "lib/Traversal.glsl"

// The cell in the middle of the voxel cell that a cell lies in, and a place in that voxel cell, from the middle one on.
ivec3 middleOf(ivec3 cell) { return REFINEMENT * voxelCell(cell); }
vec3 withinMiddle(vec3 place) { return clamp(place, -float(REFINEMENT / 2), float(REFINEMENT / 2 + 1)); }

// The rest of a cell of the voxels' grid.
Block voxelBlockAt(ivec3 cell, ivec3 upwards) {
  return Block(cell, middleOf(cell) + (REFINEMENT / 2) * (2 * upwards - 1), 0);
}
