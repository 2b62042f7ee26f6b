// Stored values of the volume. Texels of one and two bytes are integers, normalised (exact: they are rounded back); those
// of four are floats.
#include <schedule>
#include "lib/Grid.glsl"

// Corners of a cell (cell frame) are counted x fastest.
ivec3 cornerOf(int i) { return ivec3(i & 1, (i >> 1) & 1, i >> 2); }

// SPLINE: the volume is the spline itself, of which texels are samples on a finer grid; else it is what lies between texels.
// A shader declares the textures of the one or the other, for it may declare eight images.
#if SPLINE
#include "lib/Spline.glsl"

float storedExact(vec3 position) {
  ivec3 cell = ivec3(floor(position));
  return splineAt(cell, position - vec3(cell));
}
#else
// Texels, and stored values per texel unit.
#if VOLUME_BYTES == 1
TEXELS_3D(r8, volumeTexels);
const float TEXEL_SCALE = 255.0;
#elif VOLUME_BYTES == 2
TEXELS_3D(r16, volumeTexels);
const float TEXEL_SCALE = 65535.0;
#else
TEXELS_3D(r32f, volumeTexels);
const float TEXEL_SCALE = 1.0;
#endif

float storedAt(ivec3 index) {
  float texel = texelOf(volumeTexels, clamp(index, ivec3(0), volume.dims - 1)).r;
#if VOLUME_BYTES == 4
  return texel;
#else
  return floor(texel * TEXEL_SCALE + 0.5);
#endif
}

void cellCorners(ivec3 cell, out float f[8]) {
  for (int i = 0; i < 8; ++i) f[i] = storedAt(cell - 1 + cornerOf(i));
}

// Trilinear between texels, with full float weights: hardware filters have 8-bit ones.
float storedBetween(vec3 position) {
  ivec3 cell = ivec3(floor(position));
  vec3 w = position - vec3(cell);
  float f[8];
  cellCorners(cell, f);
  vec4 x = mix(vec4(f[0], f[2], f[4], f[6]), vec4(f[1], f[3], f[5], f[7]), w.x);
  vec2 y = mix(x.xz, x.yw, w.y);
  return mix(y.x, y.y, w.z);
}

float storedExact(vec3 position) { return storedBetween(position); }
#endif
