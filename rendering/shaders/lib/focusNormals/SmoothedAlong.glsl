// A focus of labels is lit by the gradient of a smoothed indicator, along paths through cells (the interface is described in
// None.glsl).
#include <schedule>
#include "lib/Crossing.glsl"
#include "lib/Grid.glsl"
#include "lib/Uniforms.glsl"

TEXELS_3D(r16, focusSmoothTexels);  // the indicator

const bool OWN_NORMALS = true;
const float FLAT_FOCUS = 1e-6;

// Central difference of the indicator along an axis at corner i of a cell, from the cell's corners and the voxel beyond.
// `first`: the texel of corner 0.
float smoothedDifference(float inner[8], ivec3 first, int i, int axis) {
  int across = i ^ (1 << axis);
  bool isUpper = across < i;
  ivec3 step = ivec3(axis == 0, axis == 1, axis == 2);
  float outer = texelOf(focusSmoothTexels, first + cornerOf(i) + (isUpper ? step : -step)).r;
  return isUpper ? outer - inner[across] : inner[across] - outer;
}

// What focusNormal() of Smoothed.glsl is between the cell's corners.
void focusNormalsAlong(ivec3 cell, vec3 a, vec3 b, out vec3 along[4]) {
  ivec3 first = voxelCell(cell) - 1 - ivec3(floor(focus.smoothOrigin));
  float inner[8];
  for (int i = 0; i < 8; ++i) inner[i] = texelOf(focusSmoothTexels, first + cornerOf(i)).r;
  vec3 f[8];
  for (int i = 0; i < 8; ++i)
    f[i] = vec3(smoothedDifference(inner, first, i, 0), smoothedDifference(inner, first, i, 1),
                smoothedDifference(inner, first, i, 2));
  bernsteinAlong(f, withinVoxelCell(cell, a), withinVoxelCell(cell, b), along);
  for (int k = 0; k < 4; ++k) along[k] = focus.worldFromIndexGradient * along[k];
}
