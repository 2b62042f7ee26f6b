// Brush strokes have edited the picture (the interface is described in None.glsl).
#include <schedule>

TEXELS_2D(rg32f, editMap);

const bool EDITED = true;

vec2 editAt(ivec2 pixel) { return texelOf(editMap, pixel).rg; }
