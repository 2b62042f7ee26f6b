// Faint labels have transfer functions of their own in the context (rendering/scene/FaintLabels.h): the function at a point is
// that of the nearest voxel's label (the interface is described in One.glsl).
#include "lib/Grid.glsl"

uniform ivec3 faintOrigin, faintSize;  // voxels that faintIndex holds: the first, and how many
uniform ivec3 lastVoxel;               // of the volume

// See rendering/gpu/FaintIndex.h. Not an image, of which a shader may have eight.
uniform usampler3D faintIndex;

const bool HAS_FAINT = true;

uint faintTexel(ivec3 voxel) {
  ivec3 at = voxel - faintOrigin;
  uint texel = texelFetch(faintIndex, clamp(at, ivec3(0), faintSize - 1), 0).r;
  return at == clamp(at, ivec3(0), faintSize - 1) ? texel : 0u;
}

uint functionsIn(ivec3 cell) { return faintTexel(voxelCell(cell) - 1); }
bool functionsDiffer(uint functions) { return functions >= 128u; }

int functionAt(vec3 at) {
  ivec3 voxel = ivec3(floor(voxelPosition(at) - 0.5));
  return int(faintTexel(clamp(voxel, ivec3(0), lastVoxel)) & 127u);
}

float nextFunction(vec3 a, vec3 b, float u) { return nextNearest(a, b, u); }
