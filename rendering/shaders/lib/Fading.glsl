// A context that fades (MethodStages::Fading in rendering/scene/Method.h): what its extinction is multiplied by.
//
// FADING is 0 in pictures in which nothing fades: nothing of this file is compiled then. It is 1 where light, nearness and
// what lies before decide, 2 around a focal region, 4 around one that ends at a distance from the focus, and 3 where an
// opening is ghosted.
#include <schedule>
#include "lib/Crossing.glsl"
#include "lib/Volume.glsl"
#ifndef FADING
#define FADING 0
#endif
#if FADING == 2
#include "lib/FocalRegion.glsl"
#elif FADING == 3
#include "lib/Ghosting.glsl"
#elif FADING == 4
#include "lib/FocalDistance.glsl"
#endif
#if FADING

struct FadingSettings {
  mat3 slopeFromIndex;  // gradients: world, 1 for the steepest, from those of coded values by the voxel's index
  vec2 nearness;        // 1 - d = s · x + y
  float reach;
  float sharpness;
};
// Uniforms of their own and no block: while lavapipe of Mesa 22.3 prepares a program whose branches depend on an eighth
// uniform buffer, it writes beyond its own memory (crashesTheDriver() in tests/gl/SceneKinds.h).
uniform vec3 slopeFromIndexX, slopeFromIndexY, slopeFromIndexZ;  // columns
uniform vec2 fadingNearness;
uniform float fadingReach, fadingSharpness;
FadingSettings fading = FadingSettings(mat3(slopeFromIndexX, slopeFromIndexY, slopeFromIndexZ), fadingNearness,
                                       fadingReach, fadingSharpness);

// At a point with a gradient of this length (steepest: 1), light and place: the binary logarithm of the factor behind
// nothing. Behind the transmittance T it is T^sharpness of that.
float fadeAt(float slope, float intensity, float s) {
  float near = clamp(s * fading.nearness.x + fading.nearness.y, 0.0, 1.0);
  float exponent = pow(fading.reach * intensity * near, fading.sharpness);
  float whole = slope > 0.0 ? exponent * log2(min(slope, 1.0)) : -1e30;
  return exponent > 0.0 ? whole : 0.0;
}

#if FADING == 2 || FADING == 4
// The same `outside` mm outside of a focal region, behind anything.
float fadeAround(float slope, float outside) {
  return slope > 0.0 ? log2(min(slope, 1.0)) - focalPerFallOff * max(outside, 0.0) : -1e30;
}
#endif

// What a straight path through a cell meets; Bernstein coefficients. `a` and `b` below are its ends as bernsteinAlong()
// has them.
struct Slopes {
  vec3 along[4];  // gradients
#if FADING == 4
  vec4 outside;   // outsideAlong()
#endif
};

#if SPLINE
// Derivatives of splineWeights().
vec4 splineSlopes(float t) {
  float s = 1.0 - t;
  return vec4(-s * s, t * (3.0 * t - 4.0), s * (4.0 - 3.0 * s), t * t) * 0.5;
}

struct SplineSlopes {
  vec3 at[POINTS];  // the spline's own gradients, at the points of a path through it
#if FADING == 4
  vec4 outside;
#endif
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
  for (int i = 0; i < POINTS; ++i) slopes.at[i] = fading.slopeFromIndex * slopes.at[i];
#if FADING == 4
  slopes.outside = outsideAlong(cell, a, b);
#endif
  return slopes;
}

// Those of a half of the path.
Slopes halfOf(SplineSlopes whole, int each) {
  vec3 v0 = each == 0 ? whole.at[0] : whole.at[3], v1 = each == 0 ? whole.at[1] : whole.at[4],
       v2 = each == 0 ? whole.at[2] : whole.at[5], v3 = each == 0 ? whole.at[3] : whole.at[6];
  Slopes slopes;
  slopes.along[0] = v0;
  slopes.along[1] = (-5.0 * v0 + 18.0 * v1 - 9.0 * v2 + 2.0 * v3) * (1.0 / 6.0);
  slopes.along[2] = (2.0 * v0 - 9.0 * v1 + 18.0 * v2 - 5.0 * v3) * (1.0 / 6.0);
  slopes.along[3] = v3;
#if FADING == 4
  slopes.outside = bernsteinBetween(whole.outside, 0.5 * float(each), 0.5 * float(each) + 0.5);
#endif
  return slopes;
}
#else
// Central difference along an axis at corner i of a cell, from the cell's corners and the voxel beyond; one-sided at the
// volume's border.
float differenceAt(float inner[8], ivec3 cell, int i, int axis) {
  int across = i ^ (1 << axis);
  bool isUpper = across < i;
  ivec3 corner = cell - 1 + cornerOf(i), step = ivec3(axis == 0, axis == 1, axis == 2);
  float outer = storedAt(corner + (isUpper ? step : -step));
  bool isBorder = isUpper ? corner[axis] >= volume.dims[axis] - 1 : corner[axis] <= 0;
  return (isUpper ? outer - inner[across] : inner[across] - outer) * (isBorder ? 1.0 : 0.5);
}

// Central differences at the corners of a cell, `f`. What lies beyond the outermost voxels has the gradient of those: there it
// takes the cell beside, and moves the ends to its face.
void slopesAround(ivec3 cell, inout vec3 a, inout vec3 b, out vec3 f[8]) {
  ivec3 inside = clamp(cell, ivec3(1), max(volume.dims - 1, ivec3(1)));
  vec3 moved = vec3(cell - inside);
  a = clamp(a + moved, 0.0, 1.0);
  b = clamp(b + moved, 0.0, 1.0);
  float inner[8];
  cellCorners(inside, inner);
  for (int i = 0; i < 8; ++i)
    f[i] = fading.slopeFromIndex * vec3(differenceAt(inner, inside, i, 0), differenceAt(inner, inside, i, 1),
                                        differenceAt(inner, inside, i, 2));
}

Slopes slopesAlong(ivec3 cell, inout vec3 a, inout vec3 b, out vec3 f[8]) {
  Slopes slopes;
#if FADING == 4
  slopes.outside = outsideAlong(cell, a, b);
#endif
  slopesAround(cell, a, b, f);
  bernsteinAlong(f, a, b, slopes.along);
  return slopes;
}

// Their gated normals, as lib/light/Lit.glsl has them, but without the texture's rounding: where a context fades, an
// error of its light early on a ray may grow behind.
uniform vec2 gradientGate;  // of gradients of which the steepest is 1
vec3 gatedSlope(vec3 slope) {
  float size = length(slope);
  return size > gradientGate.x ? slope * (smoothstep(gradientGate.x, gradientGate.y, size) / size) : vec3(0.0);
}
#endif
#endif
