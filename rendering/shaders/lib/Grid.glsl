// The volume's grid. Cell c of the cell frame (see lib/Ray.glsl) exists for 0 ≤ c ≤ dims.
//
// Of a spline it is finer than the voxels' own, by REFINEMENT cells along the side of a voxel, an odd number (see
// rendering/gpu/RefinedVolume.h). What belongs to the voxels, such as the focus, lies in cells of their own grid.
#include <schedule>
#include "lib/Uniforms.glsl"

// The first u' > u, at most 1, where from a to b, both within a cell (0 to 1), another voxel becomes the nearest: half way
// between voxel centres, which is in the middle of cells of a finer grid, too.
float nextNearest(vec3 a, vec3 b, float u) {
  vec3 at = (0.5 - a) / (b - a);
  at = mix(vec3(1.0), at, greaterThan(at, vec3(u)));
  return min(min(at.x, at.y), min(at.z, 1.0));
}
#ifndef REFINEMENT
#define REFINEMENT 1
#endif
#ifndef SAMPLED
#define SAMPLED 0
#endif
// Of a spline, a shader reads its samples (SAMPLED) or the spline itself.
#define SPLINE (REFINEMENT > 1 && !SAMPLED)

#if REFINEMENT == 1
ivec3 voxelCell(ivec3 cell) { return cell; }
vec3 voxelPosition(vec3 position) { return position; }
vec3 withinVoxelCell(ivec3 cell, vec3 within) { return within; }
#else
// The cell of the voxels' grid that a cell lies in; a position in the cell frame of that grid; and one within that cell.
ivec3 voxelCell(ivec3 cell) { return (cell + REFINEMENT / 2) / REFINEMENT; }
vec3 voxelPosition(vec3 position) { return (position + float(REFINEMENT / 2)) * (1.0 / float(REFINEMENT)); }
vec3 withinVoxelCell(ivec3 cell, vec3 within) {
  return (vec3(cell + REFINEMENT / 2 - REFINEMENT * voxelCell(cell)) + within) * (1.0 / float(REFINEMENT));
}
// The cell in the middle of the voxel cell that a cell lies in, and a place in that voxel cell, from the middle one on.
ivec3 middleOf(ivec3 cell) { return REFINEMENT * voxelCell(cell); }
vec3 withinMiddle(vec3 place) { return clamp(place, -float(REFINEMENT / 2), float(REFINEMENT / 2 + 1)); }
#endif
