// The volume is what lies between its texels, trilinear.
//
// Spline.glsl has the same interface; `#include <volume>` names the one that the scene needs. A program declares the
// textures of the one or the other, because it may declare eight images.
//   storedExact  the stored value at a position (cell frame)
#include <schedule>
#include <voxels>
#include "lib/Grid.glsl"
#include "lib/Uniforms.glsl"

float storedAt(ivec3 index) {
  float texel = texelOf(volumeTexels, clamp(index, ivec3(0), volume.dims - 1)).r;
  return storedOf(texel);
}

void cellCorners(ivec3 cell, out float f[8]) {
  for (int i = 0; i < 8; ++i) f[i] = storedAt(cell - 1 + cornerOf(i));
}

// With full float weights: hardware filters have 8-bit ones.
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
