// The volume's grid. Cell c of the cell frame (see lib/Ray.glsl) exists for 0 ≤ c ≤ dims.
#include <schedule>

struct VolumeSettings {
  ivec3 dims;  // voxels
};
UNIFORM_BLOCK(VolumeBlock, storedVolume, VolumeSettings, volume);

// The first u' > u, at most 1, where from a to b, both within a cell (0 to 1), another voxel becomes the nearest: half way
// between voxel centres.
float nextNearest(vec3 a, vec3 b, float u) {
  vec3 at = (0.5 - a) / (b - a);
  at = mix(vec3(1.0), at, greaterThan(at, vec3(u)));
  return min(min(at.x, at.y), min(at.z, 1.0));
}
