// Shaders walk the voxels' own grid.
//
// Refined.glsl has the same interface; `#include <grid>` names the one that the scene needs:
//   voxelCell        the cell of the voxels' grid that a cell lies in
//   voxelPosition    a position in the cell frame of the voxels' grid
//   withinVoxelCell  a place within a cell, as a place within the voxels' cell

ivec3 voxelCell(ivec3 cell) { return cell; }
vec3 voxelPosition(vec3 position) { return position; }
vec3 withinVoxelCell(ivec3 cell, vec3 within) { return within; }
