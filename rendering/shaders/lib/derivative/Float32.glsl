// The derivative volume with texels of four bytes (Uint16.glsl).
#include <schedule>

TEXELS_3D(r32f, derivativeVolume);
