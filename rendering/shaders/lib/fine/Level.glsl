// Any other level (the interface is described in Hits.glsl).
#include <schedule>

TEXELS_2D(r32f, fine);

float fineValue(ivec2 pixel) { return texelOf(fine, pixel).x; }
