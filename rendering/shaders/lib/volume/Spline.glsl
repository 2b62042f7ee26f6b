// The volume is a spline (rendering/scene/SplineVolume.h), read from its coefficients: at a position, and along a path through
// a cell of the voxels' grid (the interface is described in Trilinear.glsl).
#include <schedule>
#include "lib/Grid.glsl"

// Coefficients as stored values, four along x from a texel's on; the first of each axis belongs to index -1.
TEXELS_3D(rgba32f, splineTexels);

// A field is a polynomial of degree 9 along the path. It is known from seven values at equal distances: through them goes a
// polynomial of degree 6, and through four of them a cubic, which is right to (1/6)^4/24 of the fourth derivative over a
// half of the path, lengths in voxels.
const int POINTS = 7, HALVES = 2;

struct SplineAlong {
  float at[POINTS];
};

// Bernstein coefficients of the cubic through four values at equal distances.
vec4 bernsteinThrough(float v0, float v1, float v2, float v3) {
  return vec4(v0, (-5.0 * v0 + 18.0 * v1 - 9.0 * v2 + 2.0 * v3) * (1.0 / 6.0),
              (2.0 * v0 - 9.0 * v1 + 18.0 * v2 - 5.0 * v3) * (1.0 / 6.0), v3);
}

vec4 halfOf(SplineAlong along, int each) {
  return each == 0 ? bernsteinThrough(along.at[0], along.at[1], along.at[2], along.at[3])
                   : bernsteinThrough(along.at[3], along.at[4], along.at[5], along.at[6]);
}

// Cubic B-spline weights of the coefficients around a position, t from the second on.
vec4 splineWeights(float t) {
  float s = 1.0 - t;
  return vec4(s * s * s, 4.0 - 3.0 * t * t * (2.0 - t), 4.0 - 3.0 * s * s * (2.0 - s), t * t * t) * (1.0 / 6.0);
}

struct SplinePath {
  ivec3 base;     // of the first coefficient of all points
  vec3 from, to;  // ends between the second and the third coefficient, 0 to 1
};

// `a` and `b`: ends, in one voxel cell, in units of the finer grid's cells from `cell` on, one of those in that cell.
SplinePath splinePath(ivec3 cell, vec3 a, vec3 b) {
  ivec3 voxels = volume.dims / REFINEMENT, owner = voxelCell(cell);
  SplinePath path;
  path.base = clamp(owner - 1, ivec3(0), max(voxels - 2, ivec3(0)));
  // Beyond the outermost voxels a field goes on as it is there.
  vec3 last = min(vec3(voxels - 1), vec3(1.0)), before = vec3(owner - 1 - path.base);
  path.from = clamp(before + withinVoxelCell(cell, a), vec3(0.0), last);
  path.to = clamp(before + withinVoxelCell(cell, b), vec3(0.0), last);
  return path;
}

SplineAlong splineAlong(ivec3 cell, vec3 a, vec3 b) {
  SplinePath path = splinePath(cell, a, b);
  vec4 x[POINTS], y[POINTS], z[POINTS];
  float v[POINTS];
  for (int i = 0; i < POINTS; ++i) {
    vec3 t = mix(path.from, path.to, float(i) / float(POINTS - 1));
    x[i] = splineWeights(t.x);
    y[i] = splineWeights(t.y);
    z[i] = splineWeights(t.z);
    v[i] = 0.0;
  }
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      vec4 row = texelOf(splineTexels, path.base + ivec3(0, j, k));
      for (int i = 0; i < POINTS; ++i) v[i] += dot(row, x[i]) * (y[i][j] * z[i][k]);
    }
  return SplineAlong(v);
}

float splineAt(ivec3 cell, vec3 within) {
  SplinePath path = splinePath(cell, within, within);
  vec4 x = splineWeights(path.from.x), y = splineWeights(path.from.y), z = splineWeights(path.from.z);
  float v = 0.0;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) v += dot(texelOf(splineTexels, path.base + ivec3(0, j, k)), x) * (y[j] * z[k]);
  return v;
}

float storedExact(vec3 position) {
  ivec3 cell = ivec3(floor(position));
  return splineAt(cell, position - vec3(cell));
}
