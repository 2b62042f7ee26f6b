// What lies within a distance from the focus shows as it is while the context around it fades
// (rendering/scene/FocusDistances.h; the interface is described in None.glsl).
#include "lib/Crossing.glsl"
#include "lib/Grid.glsl"
#include "lib/fading/Focal.glsl"

layout(std430, binding = 5) readonly buffer FocalDistances { float focalDistances[]; };  // mm, at the lattice's points
uniform ivec3 focalStep, focalPoints, focalDims;  // voxels between points, points, voxels

const bool BORDERS_IN_TURN = true;

// `a` and `b`: the path's ends within the cell.
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

float fadeOf(Slopes slopes, float along, Ray ray, float s, vec2 light) {
  vec3 slope = bernstein(slopes.along, along);
  return fadeAround(length(slope), bernstein(slopes.outside, along));
}

vec2 wholeBehind(Slopes slopes, vec2 within, Ray ray, vec2 ends, float x) {
  vec4 outside = slopes.outside;
  float extent = max(within.y - within.x, 1e-12), u = mix(within.x, within.y, x), next = nextSignChange(outside, u);
  // A crossing of which only the rounding lies behind x is that at which the step before ended.
  if (next - u < 1e-6 * extent) next = nextSignChange(outside, u + 1e-6 * extent);
  float border = (next - within.x) / extent;
  return bernstein(outside, 0.5 * (u + next)) > 0.0 ? vec2(border, 3e38) : vec2(-3e38, border);
}
