// A region that shows as it is, as far as a distance from the focus (rendering/scene/FocusDistances.h). No file is
// included here that others include: those would lack it where FADING is not 4.

layout(std430, binding = 5) readonly buffer FocalDistances { float focalDistances[]; };  // mm, at the lattice's points

// Uniforms of their own, as those of lib/Fading.glsl.
uniform ivec3 focalStep, focalPoints, focalDims;  // voxels between points, points, voxels
uniform float focalSize, focalPerFallOff;

// mm outside of the region along a path, negative inside; Bernstein coefficients. `a` and `b`: the path's ends within the
// cell.
vec4 outsideAlong(ivec3 cell, vec3 a, vec3 b) {
  // Between the outermost voxels' centres.
  ivec3 lastCell = max(focalDims - 2, 0), voxel = voxelCell(cell) - 1, inside = clamp(voxel, ivec3(0), lastCell);
  vec3 moved = vec3(voxel - inside), highest = min(vec3(focalDims - 1), 1.0);
  vec3 from = clamp(withinVoxelCell(cell, a) + moved, vec3(0.0), highest);
  vec3 to = clamp(withinVoxelCell(cell, b) + moved, vec3(0.0), highest);
  ivec3 point = inside / focalStep;
  vec3 first = vec3(inside - point * focalStep), perStep = 1.0 / vec3(focalStep);
  float corners[8];
  for (int i = 0; i < 8; ++i) {
    ivec3 at = point + cornerOf(i);
    corners[i] = focalDistances[at.x + focalPoints.x * (at.y + focalPoints.y * at.z)] - focalSize;
  }
  return bernsteinAlong(corners, (first + from) * perStep, (first + to) * perStep);
}
