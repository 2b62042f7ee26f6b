// The volume's grid. Cell c of the cell frame (see lib/Ray.glsl) exists for 0 ≤ c ≤ dims.
#include <schedule>

struct VolumeSettings {
  ivec3 dims;  // voxels
};
UNIFORM_BLOCK(VolumeBlock, storedVolume, VolumeSettings, volume);
