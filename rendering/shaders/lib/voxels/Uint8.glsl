// Texels of one byte: integers, normalised, which rounding restores exactly.
//
// Uint16.glsl and Float32.glsl have the same interface; `#include <voxels>` names the one that the volume needs:
//   volumeTexels  the volume, a texel a point of the grid that shaders walk
//   TEXEL_SCALE   stored values per texel unit
//   storedOf      the stored value of a texel
#include <schedule>

TEXELS_3D(r8, volumeTexels);

const float TEXEL_SCALE = 255.0;

float storedOf(float texel) { return floor(texel * TEXEL_SCALE + 0.5); }
