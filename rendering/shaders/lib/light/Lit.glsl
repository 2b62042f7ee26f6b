// The lighting model (rendering/scene/Lighting.h) at points of the volume and along paths through its cells.
//
// Unlit.glsl has the same interface; `#include <light>` names the one that the scene needs:
//   LIT               whether there is any lighting
//   lightOf           the light on a surface with a normal
//   gatedAt           the gated normal at a voxel
//   lightOfGated      the light at a point of the context, from the gated normal interpolated there
//   lightOfFocus      the light at a point of the focus
//   CellNormals, normalsAlong, addFocusNormals, lightAlong   the same along a path through a cell
//   piecesOfLight     into how many pieces the light along such a path has to be cut
#include <focus>
#include <schedule>
#include "lib/Crossing.glsl"
#include "lib/Volume.glsl"
#include "lib/light/BlinnPhong.glsl"

const bool LIT = true;

// Gated normals, zero at 511/1023.
TEXELS_3D(rgb10_a2, gradientTexels);

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

// At a voxel's centre.
vec3 gatedAt(ivec3 voxel) {
  ivec3 last = sizeOf(gradientTexels) - 1;
  return gatedNormal(texelOf(gradientTexels, clamp(voxel - lighting.gradientOrigin, ivec3(0), last)).xyz);
}

#if FOCUS_SMOOTH
// Smoothed indicator around a label focus: filtered, and texel by texel.
uniform sampler3D focusSmooth;
TEXELS_3D(r16, focusSmoothTexels);

// Square of the gradient (1/mm) below which a point lies too deep in the focus to have its normal.
const float FLAT_FOCUS = 1e-6;

// Gradient of the smoothed indicator (1/mm).
vec3 focusNormal(vec3 position) {
  vec3 size = vec3(textureSize(focusSmooth, 0));
  vec3 at = (position - focus.smoothOrigin) / size, e = 1.0 / size;
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
};

void bernsteinAlong(vec3 f[8], vec3 a, vec3 b, out vec3 along[4]) {
  vec4 c[3];
  for (int axis = 0; axis < 3; ++axis) {
    float g[8];
    for (int i = 0; i < 8; ++i) g[i] = f[i][axis];
    c[axis] = bernsteinAlong(g, a, b);
  }
  for (int k = 0; k < 4; ++k) along[k] = vec3(c[0][k], c[1][k], c[2][k]);
}

// `a` and `b`: the path's ends within the cell.
CellNormals normalsAlong(ivec3 cell, vec3 a, vec3 b) {
  vec3 f[8];
  for (int i = 0; i < 8; ++i) f[i] = gatedAt(cell - 1 + cornerOf(i));
  CellNormals normals;
  bernsteinAlong(f, a, b, normals.gated);
  return normals;
}

#if FOCUS_SMOOTH
// What focusNormal() is between the cell's corners.
void addFocusNormals(inout CellNormals normals, ivec3 cell, vec3 a, vec3 b) {
  ivec3 first = cell - 1 - ivec3(floor(focus.smoothOrigin));
  float inner[8];
  for (int i = 0; i < 8; ++i) inner[i] = texelOf(focusSmoothTexels, first + cornerOf(i)).r;
  vec3 f[8];
  for (int i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      int across = i ^ (1 << axis);
      ivec3 beyond = cornerOf(i);
      beyond[axis] += across < i ? 1 : -1;
      float outer = texelOf(focusSmoothTexels, first + beyond).r;
      f[i][axis] = across < i ? outer - inner[across] : inner[across] - outer;
    }
  bernsteinAlong(f, a, b, normals.focus);
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

// Into how many pieces a section has to be cut so that no two of them can agree on its light by chance. `weight`: how
// many times what is allowed a light of 1 would be. `surface`: where in a piece light comes from is not known.
float piecesOfLight(vec3 normals[4], float leastLength, vec3 rayDirection, float weight, bool surface) {
  vec3 middle = bernstein(normals, 0.5);
  float size = length(middle);
  vec3 front = normalize(normals[0] + 1e-12), back = normalize(normals[3] + 1e-12), between = normalize(middle + 1e-12);
  // Either side of a surface is lit alike.
  vec2 cosines = abs(vec2(dot(front, between), dot(between, back))), chords = sqrt(max(2.0 - 2.0 * cosines, 0.0));
  float turn = chords.x + chords.y;

  // The midpoint rule in n pieces is wrong by 1/(24 n²) of the change in slope. Diffuse light's slope changes by no
  // more than the normals turn.
  float pieces = turn * sqrt(weight * lighting.diffuse / 24.0);

  // cos^shininess is much like a Gaussian of this standard deviation: where a highlight may lie between two points,
  // they lie closer than that; its slope reaches 0.6 of its height over it.
  float width = inversesqrt(lighting.shininess), cosine = abs(dot(between, normalize(lighting.direction - rayDirection)));
  float highlight = weight * lighting.specular * pow(min(cosine + 0.5 * turn, 1.0), lighting.shininess);
  if (highlight > 1.0) pieces = max(pieces, max(turn / width, sqrt(highlight * turn * (1.2 / 24.0) / width)));

  // Where normals turn from one side of the light to the other, |n·l| has a kink: |x| from end to end through 0 is in n
  // pieces wrong by at most 1/(4 n²) of the change.
  vec4 towards = vec4(dot(normals[0], lighting.direction), dot(normals[1], lighting.direction),
                      dot(normals[2], lighting.direction), dot(normals[3], lighting.direction));
  float low = min(min(towards.x, towards.y), min(towards.z, towards.w));
  float high = max(max(towards.x, towards.y), max(towards.z, towards.w));
  float kink = low < 0.0 && high > 0.0 ? lighting.diffuse * min((high - low) / max(size, leastLength), 2.0) : 0.0;
  pieces = max(pieces, 0.5 * sqrt(weight * kink));

  return surface ? max(pieces, weight * turn * (lighting.diffuse + lighting.specular / width)) : pieces;
}

float piecesOfLight(CellNormals normals, bool ofFocus, vec3 rayDirection, float weight, bool surface) {
#if FOCUS_SMOOTH
  if (ofFocus) return piecesOfLight(normals.focus, 1e-3, rayDirection, weight, surface);
#endif
  // Shorter ones count for less: certainty over length is at most 9/8 of 1 / certainLength.
  return piecesOfLight(normals.gated, lighting.certainLength * 8.0 / 9.0, rayDirection, weight, surface);
}
