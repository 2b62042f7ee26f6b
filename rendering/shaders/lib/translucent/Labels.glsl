// Labels of the context are translucent: a point has its nearest voxel's label (the interface is described in None.glsl).
#include "lib/Grid.glsl"

uniform ivec3 faintOrigin, faintSize;  // voxels that faintIndex holds: the first, and how many
uniform ivec3 lastVoxel;               // of the volume

// See rendering/gpu/FaintIndex.h. Not images, of which a shader may have eight.
uniform usampler3D faintIndex;
uniform sampler2D faintOpacities;  // one texel a number

const bool HAS_FAINT = true;

uint faintTexel(ivec3 voxel) {
  ivec3 at = voxel - faintOrigin;
  uint texel = texelFetch(faintIndex, clamp(at, ivec3(0), faintSize - 1), 0).r;
  return at == clamp(at, ivec3(0), faintSize - 1) ? texel : 0u;
}

uint labelsIn(ivec3 cell) { return faintTexel(voxelCell(cell) - 1); }
bool labelsDiffer(uint labels) { return labels >= 128u; }

int labelAt(vec3 at) {
  ivec3 voxel = ivec3(floor(voxelPosition(at) - 0.5));
  return int(faintTexel(clamp(voxel, ivec3(0), lastVoxel)) & 127u);
}

float nextLabel(vec3 a, vec3 b, float u) { return nextNearest(a, b, u); }
float opacityOf(int label) { return texelFetch(faintOpacities, ivec2(label, 0), 0).r; }
