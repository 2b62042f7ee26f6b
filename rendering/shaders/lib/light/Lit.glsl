// The lighting model (rendering/scene/Lighting.h) at points of the volume and along paths through its cells.
//
// Unlit.glsl has the same interface; `#include <light>` names the one that the scene needs:
//   LIT               whether there is any lighting
//   lightOf           the light on a surface with a normal
//   gatedAt           the gated normal at a voxel
//   lightOfGated      the light at a point of the context, from the gated normal interpolated there
//   lightOfFocus      the light at a point of the focus
//   CellNormals, normalsAlong, addFocusNormals, lightAlong   the same along a path through a cell
//   NormalsAlong, normalsAlongSpline, halfOf   the same along a path through a spline
//   openAt, occluded  ambient occlusion and shadow, where OCCLUDED is 1 (lib/light/Occlusion.glsl)
//   intensityOf       how strongly light other than ambient is given back, 0 to 1 (lib/Fading.glsl)
//   nextTurn          the first u' > u, at most 1, where the context's normals turn from one side of the light to the
//                     other, at which that has a kink
//   piecesOfLight     into how many pieces the light along such a path has to be cut
#include <focus>
#include <schedule>
#include "lib/Crossing.glsl"
#include "lib/Fading.glsl"
#include "lib/Volume.glsl"
#include "lib/light/BlinnPhong.glsl"
#include "lib/light/Occlusion.glsl"

const bool LIT = true;

// A gated normal's light, which fades in with its length.
vec2 lightOfGated(vec3 normal, vec3 rayDirection) {
  vec2 flatLight = vec2(lighting.ambient + lighting.meanIncidence * lighting.diffuse, 0.0);
  float size = dot(normal, normal);
  if (!(size > 1e-6)) return flatLight;
  float inverse = inversesqrt(size);
  float certainty = smoothstep(0.0, lighting.certainLength, size * inverse);
  return mix(flatLight, lightOf(normal * inverse, rayDirection), certainty);
}

vec3 gatedNormal(vec3 texel) { return texel * (1023.0 / 511.0) - 1.0; }

#if !SPLINE
// Gated normals, zero at 511/1023.
TEXELS_3D(rgb10_a2, gradientTexels);

// At a voxel's centre.
vec3 gatedAt(ivec3 voxel) {
  ivec3 last = sizeOf(gradientTexels) - 1;
  return gatedNormal(texelOf(gradientTexels, clamp(voxel - lighting.gradientOrigin, ivec3(0), last)).xyz);
}
#endif

#if FOCUS_SMOOTH
// Smoothed indicator around a label focus: filtered, and texel by texel.
uniform sampler3D focusSmooth;
#if !SAMPLED
TEXELS_3D(r16, focusSmoothTexels);
#endif

// Square of the gradient (1/mm) below which a point lies too deep in the focus to have its normal.
const float FLAT_FOCUS = 1e-6;

// Gradient of the smoothed indicator (1/mm).
vec3 focusNormal(vec3 position) {
  vec3 size = vec3(textureSize(focusSmooth, 0));
  vec3 at = (voxelPosition(position) - focus.smoothOrigin) / size, e = 1.0 / size;
  vec3 g = vec3(textureLod(focusSmooth, at + vec3(e.x, 0, 0), 0.0).r - textureLod(focusSmooth, at - vec3(e.x, 0, 0), 0.0).r,
                textureLod(focusSmooth, at + vec3(0, e.y, 0), 0.0).r - textureLod(focusSmooth, at - vec3(0, e.y, 0), 0.0).r,
                textureLod(focusSmooth, at + vec3(0, 0, e.z), 0.0).r - textureLod(focusSmooth, at - vec3(0, 0, e.z), 0.0).r);
  return focus.worldFromIndexGradient * g;
}
#endif

// `gated`: the gated normal at the position (cell frame), for where the focus has no normal of its own.
vec2 lightOfFocus(vec3 gated, vec3 position, vec3 rayDirection) {
#if FOCUS_SMOOTH
  vec3 smoothed = focusNormal(position);
  if (dot(smoothed, smoothed) > FLAT_FOCUS) return lightOf(normalize(smoothed), rayDirection);
#endif
  return lightOfGated(gated, rayDirection);
}

// Normals along a straight path through a cell: trilinear in it, so cubics, and known from its corners alone.
// Bernstein coefficients.
struct CellNormals {
  vec3 gated[4];
#if FOCUS_SMOOTH
  vec3 focus[4];
#endif
#if FADING
  Slopes slopes;
#endif
};

#if SPLINE
TEXELS_3D(rgb10_a2, normalTexels);  // coefficients of the gated normals, as those of the spline

// Gated normals at the points of a path through a spline (lib/Spline.glsl).
struct NormalsAlong {
  vec3 at[POINTS];
#if FADING
  SplineSlopes slopes;
#endif
};

NormalsAlong normalsAlongSpline(ivec3 cell, vec3 a, vec3 b) {
  SplinePath path = splinePath(cell, a, b);
  vec4 x[POINTS], y[POINTS], z[POINTS];
  NormalsAlong normals;
  for (int i = 0; i < POINTS; ++i) {
    vec3 t = mix(path.from, path.to, float(i) / float(POINTS - 1));
    x[i] = splineWeights(t.x);
    y[i] = splineWeights(t.y);
    z[i] = splineWeights(t.z);
    normals.at[i] = vec3(0.0);
  }
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      ivec3 first = path.base + ivec3(0, j, k);
      vec3 c0 = texelOf(normalTexels, first).xyz, c1 = texelOf(normalTexels, first + ivec3(1, 0, 0)).xyz,
           c2 = texelOf(normalTexels, first + ivec3(2, 0, 0)).xyz, c3 = texelOf(normalTexels, first + ivec3(3, 0, 0)).xyz;
      for (int i = 0; i < POINTS; ++i)
        normals.at[i] += (y[i][j] * z[i][k]) * (c0 * x[i].x + c1 * x[i].y + c2 * x[i].z + c3 * x[i].w);
    }
  for (int i = 0; i < POINTS; ++i) normals.at[i] = gatedNormal(normals.at[i]);
#if FADING
  normals.slopes = slopesAlongSpline(cell, a, b);
#endif
  return normals;
}

CellNormals halfOf(NormalsAlong normals, int each) {
  vec3 v0 = each == 0 ? normals.at[0] : normals.at[3], v1 = each == 0 ? normals.at[1] : normals.at[4],
       v2 = each == 0 ? normals.at[2] : normals.at[5], v3 = each == 0 ? normals.at[3] : normals.at[6];
  CellNormals result;
  result.gated[0] = v0;
  result.gated[1] = (-5.0 * v0 + 18.0 * v1 - 9.0 * v2 + 2.0 * v3) * (1.0 / 6.0);
  result.gated[2] = (2.0 * v0 - 9.0 * v1 + 18.0 * v2 - 5.0 * v3) * (1.0 / 6.0);
  result.gated[3] = v3;
#if FADING
  result.slopes = halfOf(normals.slopes, each);
#endif
  return result;
}
#else
// `a` and `b`: the path's ends within the cell.
CellNormals normalsAlong(ivec3 cell, vec3 a, vec3 b) {
  vec3 f[8];
  CellNormals normals;
#if FADING
  normals.slopes = slopesAlong(cell, a, b, f);
  for (int i = 0; i < 8; ++i) f[i] = gatedSlope(f[i]);
#else
  for (int i = 0; i < 8; ++i) f[i] = gatedAt(cell - 1 + cornerOf(i));
#endif
  bernsteinAlong(f, a, b, normals.gated);
  return normals;
}
#endif

#if FOCUS_SMOOTH && !SAMPLED
// Central difference of the smoothed indicator along an axis at corner i of a cell, from the cell's corners and the voxel
// beyond. `first`: the texel of corner 0.
float smoothedDifference(float inner[8], ivec3 first, int i, int axis) {
  int across = i ^ (1 << axis);
  bool isUpper = across < i;
  ivec3 step = ivec3(axis == 0, axis == 1, axis == 2);
  float outer = texelOf(focusSmoothTexels, first + cornerOf(i) + (isUpper ? step : -step)).r;
  return isUpper ? outer - inner[across] : inner[across] - outer;
}

// What focusNormal() is between the cell's corners.
void addFocusNormals(inout CellNormals normals, ivec3 cell, vec3 a, vec3 b) {
  ivec3 first = voxelCell(cell) - 1 - ivec3(floor(focus.smoothOrigin));
  float inner[8];
  for (int i = 0; i < 8; ++i) inner[i] = texelOf(focusSmoothTexels, first + cornerOf(i)).r;
  vec3 f[8];
  for (int i = 0; i < 8; ++i)
    f[i] = vec3(smoothedDifference(inner, first, i, 0), smoothedDifference(inner, first, i, 1),
                smoothedDifference(inner, first, i, 2));
  bernsteinAlong(f, withinVoxelCell(cell, a), withinVoxelCell(cell, b), normals.focus);
  for (int k = 0; k < 4; ++k) normals.focus[k] = focus.worldFromIndexGradient * normals.focus[k];
}
#else
void addFocusNormals(inout CellNormals normals, ivec3 cell, vec3 a, vec3 b) {}
#endif

vec2 lightAlong(CellNormals normals, float u, vec3 rayDirection, bool ofFocus) {
#if FOCUS_SMOOTH
  vec3 smoothed = bernstein(normals.focus, u);
  if (ofFocus && dot(smoothed, smoothed) > FLAT_FOCUS) return lightOf(normalize(smoothed), rayDirection);
#endif
  return lightOfGated(bernstein(normals.gated, u), rayDirection);
}

float intensityOf(vec2 light) { return clamp(light.x - lighting.ambient + light.y, 0.0, 1.0); }

// Where |n·l| has its next kink behind u.
float nextTurn(CellNormals normals, float u) {
  return nextSignChange(vec4(dot(normals.gated[0], lighting.direction), dot(normals.gated[1], lighting.direction),
                             dot(normals.gated[2], lighting.direction), dot(normals.gated[3], lighting.direction)), u);
}

// Into how many pieces a part of a path, from u to u', has to be cut for the bends of its light that three points cannot
// tell. `weight`: how many times what is allowed a light of 1 would be.
float piecesOfLight(vec3 normals[4], float from, float to, float leastLength, vec3 rayDirection, float weight) {
  vec3 first = bernstein(normals, from), middle = bernstein(normals, 0.5 * (from + to)), last = bernstein(normals, to);
  vec3 front = normalize(first + 1e-12), back = normalize(last + 1e-12), between = normalize(middle + 1e-12);
  // Either side of a surface is lit alike.
  vec2 cosines = abs(vec2(dot(front, between), dot(between, back))), chords = sqrt(max(2.0 - 2.0 * cosines, 0.0));
  float turn = chords.x + chords.y, pieces = 0.5 * turn * sqrt(weight * lighting.diffuse / 24.0);

  // cos^shininess is much like a Gaussian of the standard deviation 1/√shininess: where a highlight may lie between two
  // points, they lie closer than that. A parabola through three points that far apart, weighted by what is seen of it,
  // is wrong by at most an 18th of the highlight, and by the third power of their distance.
  float cosine = abs(dot(between, normalize(lighting.direction - rayDirection)));
  float highlight = weight * lighting.specular * pow(min(cosine + 0.5 * turn, 1.0), lighting.shininess);
  float closer = max(pow(highlight * (1.0 / 18.0), 1.0 / 3.0), 1.0);
  if (highlight > 1.0) pieces = max(pieces, 0.5 * turn * sqrt(lighting.shininess) * closer);

  // Where normals turn from one side of the light to the other, |n·l| has a kink: a parabola through three points is in n
  // pieces wrong by at most 1/(4 n²) of the change from end to end, where most is seen of the kink itself.
  vec3 towards = vec3(dot(first, lighting.direction), dot(middle, lighting.direction), dot(last, lighting.direction));
  float low = min(min(towards.x, towards.y), towards.z), high = max(max(towards.x, towards.y), towards.z);
  float kink = low < 0.0 && high > 0.0 ? lighting.diffuse * min((high - low) / max(length(middle), leastLength), 2.0) : 0.0;
  return max(pieces, 0.5 * sqrt(weight * kink));
}

float piecesOfLight(CellNormals normals, float from, float to, bool ofFocus, vec3 rayDirection, float weight) {
#if FOCUS_SMOOTH
  if (ofFocus) {
    // Light jumps where the focus's own normals end. A parabola beside a jump is wrong by a third of it.
    vec3 first = bernstein(normals.focus, from), middle = bernstein(normals.focus, 0.5 * (from + to)),
         last = bernstein(normals.focus, to);
    vec3 squares = vec3(dot(first, first), dot(middle, middle), dot(last, last));
    bool jumps = any(greaterThan(squares, vec3(FLAT_FOCUS))) && any(lessThanEqual(squares, vec3(FLAT_FOCUS)));
    float pieces = jumps ? weight * (lighting.diffuse + lighting.specular) / 3.0 : 0.0;
    return max(pieces, piecesOfLight(normals.focus, from, to, 1e-3, rayDirection, weight));
  }
#endif
  // Shorter ones count for less: certainty over length is at most 9/8 of 1 / certainLength.
  return piecesOfLight(normals.gated, from, to, lighting.certainLength * 8.0 / 9.0, rayDirection, weight);
}
