// The finest level: the hit-point map, which holds the focus hit in y.
//
// Level.glsl has the same interface; `#include <fine>` names the one for the finer of two levels:
//   fine       its texels
//   fineValue  a pixel's value
#include <schedule>

TEXELS_2D(rg32f, fine);

float fineValue(ivec2 pixel) { return texelOf(fine, pixel).y; }
