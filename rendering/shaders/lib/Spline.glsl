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

// Four points at equal distances from one end of a path through a cell to the other. A field is a polynomial of degree 9
// along the path; the cubic through its values at the points is right to (1/9)^4/24 of the fourth derivative, lengths in
// voxels.
struct SplinePath {
  ivec3 base;             // texel of the first coefficient of all four
  vec4 x[4], y[4], z[4];  // weights along each axis, by point
};

// `a` and `b`: ends within the cell, 0 to 1.
SplinePath splinePath(ivec3 cell, vec3 a, vec3 b) {
  ivec3 voxels = volume.dims / REFINEMENT, owner = voxelCell(cell);
  SplinePath path;
  path.base = clamp(owner - 1, ivec3(0), max(voxels - 2, ivec3(0)));
  // Beyond the outermost voxels a field goes on as it is there.
  vec3 last = min(vec3(voxels - 1), vec3(1.0)), before = vec3(owner - 1 - path.base);
  vec3 from = clamp(before + withinVoxelCell(cell, a), vec3(0.0), last);
  vec3 to = clamp(before + withinVoxelCell(cell, b), vec3(0.0), last);
  for (int i = 0; i < 4; ++i) {
    vec3 t = mix(from, to, float(i) / 3.0);
    path.x[i] = splineWeights(t.x);
    path.y[i] = splineWeights(t.y);
    path.z[i] = splineWeights(t.z);
  }
  return path;
}

// Weights of a row of coefficients at the four points.
vec4 rowWeights(SplinePath path, int j, int k) {
  return vec4(path.y[0][j] * path.z[0][k], path.y[1][j] * path.z[1][k], path.y[2][j] * path.z[2][k],
              path.y[3][j] * path.z[3][k]);
}

// Bernstein coefficients along the path between two points of a cell.
vec4 splineAlong(ivec3 cell, vec3 a, vec3 b) {
  SplinePath path = splinePath(cell, a, b);
  vec4 v = vec4(0.0);
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      ivec3 first = path.base + ivec3(0, j, k);
      vec4 row = vec4(texelOf(splineTexels, first).r, texelOf(splineTexels, first + ivec3(1, 0, 0)).r,
                      texelOf(splineTexels, first + ivec3(2, 0, 0)).r, texelOf(splineTexels, first + ivec3(3, 0, 0)).r);
      v += vec4(dot(row, path.x[0]), dot(row, path.x[1]), dot(row, path.x[2]), dot(row, path.x[3])) *
           rowWeights(path, j, k);
    }
  return vec4(v.x, (-5.0 * v.x + 18.0 * v.y - 9.0 * v.z + 2.0 * v.w) * (1.0 / 6.0),
              (2.0 * v.x - 9.0 * v.y + 18.0 * v.z - 5.0 * v.w) * (1.0 / 6.0), v.w);
}
