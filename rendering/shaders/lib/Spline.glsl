// A spline volume (rendering/scene/SplineVolume.h) along a path through a cell, from its coefficients. The texels of
// lib/Volume.glsl are samples of it.
#include <schedule>
#include "lib/Grid.glsl"

TEXELS_3D(r32f, splineTexels);  // coefficients as stored values; the first of each axis belongs to index -1

// Cubic B-spline weights of the coefficients around a position, t from the second on.
vec4 splineWeights(float t) {
  float s = 1.0 - t;
  return vec4(s * s * s, 4.0 - 3.0 * t * t * (2.0 - t), 4.0 - 3.0 * s * s * (2.0 - s), t * t * t) * (1.0 / 6.0);
}

// Bernstein coefficients along the path between two points of a cell, 0 to 1. The field is a polynomial of degree 9 along
// it; the cubic through four of its values is right to (1/9)^4/24 of the fourth derivative, lengths in voxels.
vec4 splineAlong(ivec3 cell, vec3 a, vec3 b) {
  ivec3 voxels = volume.dims / REFINEMENT, owner = voxelCell(cell);
  ivec3 base = clamp(owner - 1, ivec3(0), max(voxels - 2, ivec3(0)));
  vec3 last = min(vec3(voxels - 1), vec3(1.0));  // of a position behind the base, and 0 the first
  vec3 from = clamp(vec3(owner - 1 - base) + withinVoxelCell(cell, a), vec3(0.0), last);
  vec3 to = clamp(vec3(owner - 1 - base) + withinVoxelCell(cell, b), vec3(0.0), last);
  vec4 x[4], y[4], z[4];
  for (int i = 0; i < 4; ++i) {
    vec3 t = mix(from, to, float(i) / 3.0);
    x[i] = splineWeights(t.x);
    y[i] = splineWeights(t.y);
    z[i] = splineWeights(t.z);
  }
  vec4 v = vec4(0.0);
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      ivec3 first = base + ivec3(0, j, k);
      vec4 row = vec4(texelOf(splineTexels, first).r, texelOf(splineTexels, first + ivec3(1, 0, 0)).r,
                      texelOf(splineTexels, first + ivec3(2, 0, 0)).r, texelOf(splineTexels, first + ivec3(3, 0, 0)).r);
      v += vec4(dot(row, x[0]), dot(row, x[1]), dot(row, x[2]), dot(row, x[3])) *
           vec4(y[0][j] * z[0][k], y[1][j] * z[1][k], y[2][j] * z[2][k], y[3][j] * z[3][k]);
    }
  return vec4(v.x, (-5.0 * v.x + 18.0 * v.y - 9.0 * v.z + 2.0 * v.w) * (1.0 / 6.0),
              (2.0 * v.x - 9.0 * v.y + 18.0 * v.z - 5.0 * v.w) * (1.0 / 6.0), v.w);
}
