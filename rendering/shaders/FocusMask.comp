// Stage 3, first step: the focus projection, or all that an opening opens, as one bit a pixel, 32 pixels of a row in a word.
#include <mask>
#include <schedule>
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
TEXELS_2D(rg32f, hitPoints);
layout(r32ui) uniform writeonly uimage2D focusMask;

void main() {
  ivec2 at = regionPixel();
  if (any(greaterThanEqual(at, imageSize(focusMask)))) return;
  int width = sizeOf(hitPoints).x;
  uint word = 0u;
  for (int bit = 0; bit < 32; ++bit) {
    ivec2 pixel = ivec2(at.x * 32 + bit, at.y);
    if (pixel.x < width && isInside(pixel, texelOf(hitPoints, pixel).xy)) word |= 1u << bit;
  }
  imageStore(focusMask, at, uvec4(word));
}
