// Normals and slopes along a path through a cell of a spline.
#include <fading>
#include <light>
#include <normals>
#include <volume>
#include "lib/Crossing.glsl"
#include "lib/integral/PathLight.glsl"
#include "lib/normals/GatedNormal.glsl"

// Derivatives of splineWeights().
vec4 splineSlopes(float t) {
  float s = 1.0 - t;
  return vec4(-s * s, t * (3.0 * t - 4.0), s * (4.0 - 3.0 * s), t * t) * 0.5;
}

struct SplineSlopes {
  vec3 at[POINTS];  // the spline's own gradients, at the points of a path through it
  vec4 outside;     // as Slopes has it
};

SplineSlopes slopesAlongSpline(ivec3 cell, vec3 a, vec3 b) {
  SplineSlopes slopes;
  SplinePath path = splinePath(cell, a, b);
  vec4 x[POINTS], y[POINTS], z[POINTS], dx[POINTS], dy[POINTS], dz[POINTS];
  for (int i = 0; i < POINTS; ++i) {
    vec3 t = mix(path.from, path.to, float(i) / float(POINTS - 1));
    x[i] = splineWeights(t.x);
    y[i] = splineWeights(t.y);
    z[i] = splineWeights(t.z);
    dx[i] = splineSlopes(t.x);
    dy[i] = splineSlopes(t.y);
    dz[i] = splineSlopes(t.z);
    slopes.at[i] = vec3(0.0);
  }
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      vec4 row = texelOf(splineTexels, path.base + ivec3(0, j, k));
      for (int i = 0; i < POINTS; ++i) {
        float value = dot(row, x[i]);
        slopes.at[i] += vec3(dot(row, dx[i]) * y[i][j] * z[i][k], value * dy[i][j] * z[i][k], value * y[i][j] * dz[i][k]);
      }
    }
  for (int i = 0; i < POINTS; ++i) slopes.at[i] = slopeFromIndex() * slopes.at[i];
  slopes.outside = outsideAlong(cell, a, b);
  return slopes;
}

// A half of the path: the cubics through four of the points.
void halfOf(vec3 at[POINTS], int each, out vec3 along[4]) {
  vec3 v0 = each == 0 ? at[0] : at[3], v1 = each == 0 ? at[1] : at[4], v2 = each == 0 ? at[2] : at[5],
       v3 = each == 0 ? at[3] : at[6];
  along[0] = v0;
  along[1] = (-5.0 * v0 + 18.0 * v1 - 9.0 * v2 + 2.0 * v3) * (1.0 / 6.0);
  along[2] = (2.0 * v0 - 9.0 * v1 + 18.0 * v2 - 5.0 * v3) * (1.0 / 6.0);
  along[3] = v3;
}

// Gated normals at the points of a path through a spline, in `at`.
void gatedAlongSpline(ivec3 cell, vec3 a, vec3 b, out vec3 at[POINTS]) {
  SplinePath path = splinePath(cell, a, b);
  vec4 x[POINTS], y[POINTS], z[POINTS];
  for (int i = 0; i < POINTS; ++i) {
    vec3 t = mix(path.from, path.to, float(i) / float(POINTS - 1));
    x[i] = splineWeights(t.x);
    y[i] = splineWeights(t.y);
    z[i] = splineWeights(t.z);
    at[i] = vec3(0.0);
  }
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      ivec3 first = path.base + ivec3(0, j, k);
      vec3 c0 = gatedCoefficient(first), c1 = gatedCoefficient(first + ivec3(1, 0, 0)),
           c2 = gatedCoefficient(first + ivec3(2, 0, 0)), c3 = gatedCoefficient(first + ivec3(3, 0, 0));
      for (int i = 0; i < POINTS; ++i)
        at[i] += (y[i][j] * z[i][k]) * (c0 * x[i].x + c1 * x[i].y + c2 * x[i].z + c3 * x[i].w);
    }
  for (int i = 0; i < POINTS; ++i) at[i] = gatedNormal(at[i]);
}

struct NormalsAlong {
  vec3 gated[POINTS];
  SplineSlopes slopes;
};

// `a` and `b`: the path's ends, as splinePath() has them.
NormalsAlong normalsAlongSpline(ivec3 cell, vec3 a, vec3 b) {
  NormalsAlong normals;
  if (LIT) gatedAlongSpline(cell, a, b, normals.gated);
  if (FADES) normals.slopes = slopesAlongSpline(cell, a, b);
  return normals;
}

CellNormals halfOf(NormalsAlong normals, int each) {
  CellNormals result;
  if (LIT) halfOf(normals.gated, each, result.gated);
  if (FADES) {
    halfOf(normals.slopes.at, each, result.slopes.along);
    result.slopes.outside = bernsteinBetween(normals.slopes.outside, 0.5 * float(each), 0.5 * float(each) + 0.5);
  }
  return result;
}
