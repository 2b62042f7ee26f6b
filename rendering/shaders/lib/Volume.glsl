// Stored values of the volume. The texture holds integers as normalised texels (exact: they are rounded back) or floats.

uniform sampler3D volumeTexture;
uniform float texelScale;      // stored value per texel unit: 255, 65535 or 1
uniform bool integerTexels;

float storedAt(ivec3 index) {
  float texel = texelFetch(volumeTexture, clamp(index, ivec3(0), volumeDims - 1), 0).r * texelScale;
  return integerTexels ? floor(texel + 0.5) : texel;
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
