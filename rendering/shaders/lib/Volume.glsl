// Stored values of the volume. Texels of one and two bytes are integers, normalised (exact: they are rounded back); those
// of four are floats.

// What is read texel by texel is bound as an image: llvmpipe looks up a sampler's level of detail lane by lane.
#if VOLUME_BYTES == 1
#define VOLUME_FORMAT r8
#elif VOLUME_BYTES == 2
#define VOLUME_FORMAT r16
#else
#define VOLUME_FORMAT r32f
#endif
layout(VOLUME_FORMAT) uniform readonly image3D volumeTexels;
uniform float texelScale;      // stored value per texel unit: 255, 65535 or 1

// Bricks of cells: what is skipped at once. The side is that of rendering/gpu/Bricks.h.
const int BRICK_SHIFT = 2, BRICK_SIDE = 1 << BRICK_SHIFT;

float storedAt(ivec3 index) {
  float texel = imageLoad(volumeTexels, clamp(index, ivec3(0), volumeDims - 1)).r;
#if VOLUME_BYTES == 4
  return texel;
#else
  return floor(texel * texelScale + 0.5);
#endif
}

// Corners of a cell (cell frame) are counted x fastest.
ivec3 cornerOf(int i) { return ivec3(i & 1, (i >> 1) & 1, i >> 2); }

void cellCorners(ivec3 cell, out float f[8]) {
  for (int i = 0; i < 8; ++i) f[i] = storedAt(cell - 1 + cornerOf(i));
}

// Trilinear, with full float weights: hardware filters have 8-bit ones.
float storedExact(vec3 position) {
  ivec3 cell = ivec3(floor(position));
  vec3 w = position - vec3(cell);
  float f[8];
  cellCorners(cell, f);
  vec4 x = mix(vec4(f[0], f[2], f[4], f[6]), vec4(f[1], f[3], f[5], f[7]), w.x);
  vec2 y = mix(x.xz, x.yw, w.y);
  return mix(y.x, y.y, w.z);
}
