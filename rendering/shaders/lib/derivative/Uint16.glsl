// The derivative volume: a smoothed field, coarser where the scan is fine. Texels of two bytes; `#include <derivative>` names
// this file or Float32.glsl.
#include <schedule>

TEXELS_3D(r16, derivativeVolume);
