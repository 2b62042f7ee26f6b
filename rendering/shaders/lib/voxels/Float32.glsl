// Texels of four bytes: floats, the values themselves (the interface is described in Uint8.glsl).
#include <schedule>

TEXELS_3D(r32f, volumeTexels);

const float TEXEL_SCALE = 1.0;

float storedOf(float texel) { return texel; }
