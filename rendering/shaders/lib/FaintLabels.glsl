// The context's transfer function at a point: that of the nearest voxel's label, see rendering/scene/FaintLabels.h.
// Functions are numbered from 0, the volume's; without the define FAINT_LABELS there is no other one.
#include "lib/Grid.glsl"

#if FAINT_LABELS
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

// The functions in a cell: the number of the one there, and more where there are several.
uint functionsIn(ivec3 cell) { return faintTexel(voxelCell(cell) - 1); }
bool functionsDiffer(uint functions) { return functions >= 128u; }

// At a position (cell frame).
int functionAt(vec3 at) {
  ivec3 voxel = ivec3(floor(voxelPosition(at) - 0.5));
  return int(faintTexel(clamp(voxel, ivec3(0), lastVoxel)) & 127u);
}

// The first u' > u, at most 1, where from a to b, both within a cell, the function may change.
float nextFunction(vec3 a, vec3 b, float u) { return nextNearest(a, b, u); }
#else
const bool HAS_FAINT = false;
uint functionsIn(ivec3 cell) { return 0u; }
bool functionsDiffer(uint functions) { return false; }
int functionAt(vec3 at) { return 0; }
float nextFunction(vec3 a, vec3 b, float u) { return 1.0; }
#endif
