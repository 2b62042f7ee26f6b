// Stage 3, first step: the focus projection as one bit a pixel, 32 pixels of a row in a word. With OPENED, all that an opening
// opens: also where its rays start behind the context's first hit.
#include <schedule>
#include "lib/None.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
TEXELS_2D(rg32f, hitPoints);
#if OPENED
TEXELS_2D(r32f, starts);
#endif
layout(r32ui) uniform writeonly uimage2D focusMask;

bool isInside(ivec2 pixel) {
  vec2 hit = texelOf(hitPoints, pixel).xy;
#if OPENED
  if (texelOf(starts, pixel).r > hit.x) return true;
#endif
  return !isNone(hit.y);
}

void main() {
  ivec2 at = regionPixel();
  if (any(greaterThanEqual(at, imageSize(focusMask)))) return;
  int width = sizeOf(hitPoints).x;
  uint word = 0u;
  for (int bit = 0; bit < 32; ++bit) {
    int x = at.x * 32 + bit;
    if (x < width && isInside(ivec2(x, at.y))) word |= 1u << bit;
  }
  imageStore(focusMask, at, uvec4(word));
}
