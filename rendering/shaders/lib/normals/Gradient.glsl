// Gated normals from a texture, one a voxel (the interface is described in None.glsl).
#include <schedule>
#include "lib/Uniforms.glsl"
#include "lib/normals/GatedNormal.glsl"

TEXELS_3D(rgb10_a2, gradientTexels);

vec3 gatedAt(ivec3 voxel) {
  ivec3 last = sizeOf(gradientTexels) - 1;
  return gatedNormal(texelOf(gradientTexels, clamp(voxel - lighting.gradientOrigin, ivec3(0), last)).xyz);
}
