// Texels of two bytes: integers, normalised, which rounding restores exactly (the interface is described in Uint8.glsl).
#include <schedule>

TEXELS_3D(r16, volumeTexels);

const float TEXEL_SCALE = 65535.0;

float storedOf(float texel) { return floor(texel * TEXEL_SCALE + 0.5); }
