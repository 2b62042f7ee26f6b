// Another pass has found where rays start (the interface is described in Blend.glsl).
#include <schedule>

TEXELS_2D(r32f, givenStart);

float uneditedStart(ivec2 pixel, vec2 hit, float sOut) { return texelOf(givenStart, pixel).r; }
void storeBorder(ivec2 pixel, vec2 hit) {}
