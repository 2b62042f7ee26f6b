// Shaders walk a grid that is finer than the voxels', for a spline: REFINEMENT cells, an odd number, lie along the side of a
// voxel (rendering/gpu/RefinedVolume.h; the interface is described in Voxels.glsl).

ivec3 voxelCell(ivec3 cell) { return (cell + REFINEMENT / 2) / REFINEMENT; }
vec3 voxelPosition(vec3 position) { return (position + float(REFINEMENT / 2)) * (1.0 / float(REFINEMENT)); }
vec3 withinVoxelCell(ivec3 cell, vec3 within) {
  return (vec3(cell + REFINEMENT / 2 - REFINEMENT * voxelCell(cell)) + within) * (1.0 / float(REFINEMENT));
}
