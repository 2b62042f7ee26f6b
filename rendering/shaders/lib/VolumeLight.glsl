// The lighting model (rendering/scene/Lighting.h): light at points of the volume, and on the face that the opening cut.

// Gated normals, zero at 511/1023.
layout(rgb10_a2) uniform readonly image3D gradientTexels;
uniform ivec3 gradientOrigin;       // index of its first texel's voxel; beyond them all is flat
uniform float certainLength;        // of a gated normal, from which on it is lit in full
uniform float meanIncidence;        // |n·l| where there is no normal

#if FOCUS_KIND == 1
uniform sampler3D focusSmooth;      // smoothed indicator around the focus
#if CELL_BY_CELL
layout(r16) uniform readonly image3D focusSmoothTexels;  // the same
#endif
uniform vec3 focusSmoothOrigin;     // cell frame position of its first texel's outer corner
uniform mat3 worldFromIndexGradient;

// Square of the gradient (1/mm) below which a point lies too deep in the focus to have its normal.
const float FLAT_FOCUS = 1e-6;

vec3 focusNormal(vec3 position) {
  vec3 size = vec3(textureSize(focusSmooth, 0));
  vec3 at = (position - focusSmoothOrigin) / size, e = 1.0 / size;
  vec3 g = vec3(texture(focusSmooth, at + vec3(e.x, 0, 0)).r - texture(focusSmooth, at - vec3(e.x, 0, 0)).r,
                texture(focusSmooth, at + vec3(0, e.y, 0)).r - texture(focusSmooth, at - vec3(0, e.y, 0)).r,
                texture(focusSmooth, at + vec3(0, 0, e.z)).r - texture(focusSmooth, at - vec3(0, 0, e.z)).r);
  return worldFromIndexGradient * g;
}
#endif

// A gated normal's light, which fades in with its length.
vec2 lightOfGated(vec3 normal, vec3 rayDirection) {
  vec2 flatLight = vec2(lighting.x + meanIncidence * lighting.y, 0.0);
  float size = dot(normal, normal);
  if (!(size > 1e-6)) return flatLight;
  float inverse = inversesqrt(size);
  return mix(flatLight, lightOf(normal * inverse, rayDirection), smoothstep(0.0, certainLength, size * inverse));
}

vec3 gatedNormal(vec3 texel) { return texel * (1023.0 / 511.0) - 1.0; }

// At a voxel's centre.
vec3 gatedAt(ivec3 voxel) {
  ivec3 last = imageSize(gradientTexels) - 1;
  return gatedNormal(imageLoad(gradientTexels, clamp(voxel - gradientOrigin, ivec3(0), last)).xyz);
}

#if CELL_BY_CELL
// Normals along a straight path through a cell: trilinear in it, so cubics, and known from its corners alone.
// Bernstein coefficients.
struct CellNormals {
  vec3 gated[4];
#if FOCUS_KIND == 1
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

#if FOCUS_KIND == 1
// What focusNormal() is between the cell's corners.
void focusNormalsAlong(ivec3 cell, vec3 a, vec3 b, inout CellNormals normals) {
  ivec3 first = cell - 1 - ivec3(floor(focusSmoothOrigin));
  float inner[8];
  for (int i = 0; i < 8; ++i) inner[i] = imageLoad(focusSmoothTexels, first + cornerOf(i)).r;
  vec3 f[8];
  for (int i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      int across = i ^ (1 << axis);
      ivec3 beyond = cornerOf(i);
      beyond[axis] += across < i ? 1 : -1;
      float outer = imageLoad(focusSmoothTexels, first + beyond).r;
      f[i][axis] = across < i ? outer - inner[across] : inner[across] - outer;
    }
  bernsteinAlong(f, a, b, normals.focus);
  for (int k = 0; k < 4; ++k) normals.focus[k] = worldFromIndexGradient * normals.focus[k];
}
#endif

vec2 lightAlong(CellNormals normals, float u, vec3 rayDirection, bool focus) {
#if FOCUS_KIND == 1
  vec3 smoothed = bernstein(normals.focus, u);
  if (focus && dot(smoothed, smoothed) > FLAT_FOCUS) return lightOf(normalize(smoothed), rayDirection);
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
  float pieces = turn * sqrt(weight * lighting.y / 24.0);

  // cos^shininess is much like a Gaussian of this standard deviation: where a highlight may lie between two points,
  // they lie closer than that; its slope reaches 0.6 of its height over it.
  float width = inversesqrt(lighting.w), cosine = abs(dot(between, normalize(lightDirection - rayDirection)));
  float highlight = weight * lighting.z * pow(min(cosine + 0.5 * turn, 1.0), lighting.w);
  if (highlight > 1.0) pieces = max(pieces, max(turn / width, sqrt(highlight * turn * (1.2 / 24.0) / width)));

  // Where normals turn from one side of the light to the other, |n·l| has a kink: |x| from end to end through 0 is in n
  // pieces wrong by at most 1/(4 n²) of the change.
  vec4 towards = vec4(dot(normals[0], lightDirection), dot(normals[1], lightDirection),
                      dot(normals[2], lightDirection), dot(normals[3], lightDirection));
  float low = min(min(towards.x, towards.y), min(towards.z, towards.w));
  float high = max(max(towards.x, towards.y), max(towards.z, towards.w));
  float kink = low < 0.0 && high > 0.0 ? lighting.y * min((high - low) / max(size, leastLength), 2.0) : 0.0;
  pieces = max(pieces, 0.5 * sqrt(weight * kink));

  return surface ? max(pieces, weight * turn * (lighting.y + lighting.z / width)) : pieces;
}

float piecesOfLight(CellNormals normals, bool focus, vec3 rayDirection, float weight, bool surface) {
#if FOCUS_KIND == 1
  if (focus) return piecesOfLight(normals.focus, 1e-3, rayDirection, weight, surface);
#endif
  // Shorter ones count for less: certainty over length is at most 9/8 of 1 / certainLength.
  return piecesOfLight(normals.gated, certainLength * 8.0 / 9.0, rayDirection, weight, surface);
}
#endif

#if HAS_RAY_START
uniform float wallDepth;  // mm behind a cut face over which its own light gives way to the volume's
uniform float wallShare;  // of a cut face's light that is the face's own at its surface

// Normal of the cut face at a pixel, from its neighbours' ray starts; zero where the ray does not start on a cut face.
vec3 wallNormal(ivec2 pixel, float start) {
  vec2 hit = texelFetch(hitPoints, pixel, 0).xy;
  if (!isNone(hit.y) || start <= hit.x + 0.5 * wallDepth) return vec3(0.0);
  vec3 tangent[2];
  for (int axis = 0; axis < 2; ++axis) {
    ivec2 step = ivec2(1 - axis, axis);
    ivec2 a = max(pixel - step, ivec2(0)), b = min(pixel + step, pictureSize - 1);
    float sa = imageLoad(rayStart, a).r, sb = imageLoad(rayStart, b).r;
    if (isNone(sa) || isNone(sb)) return vec3(0.0);
    tangent[axis] = worldPosition(pixelRay(b), sb) - worldPosition(pixelRay(a), sa);
  }
  vec3 n = cross(tangent[0], tangent[1]);
  float size = length(n);
  return size > 0.0 ? n / size : vec3(0.0);
}
#endif
