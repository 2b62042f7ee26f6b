// Stage 3, third step: distance in pixels to the nearest focus pixel of the same row, FAR_ROW beyond `range`.
#include <schedule>
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
UNSIGNED_TEXELS_2D(r32ui, focusMask);
UNSIGNED_TEXELS_2D(r8ui, focusTiles);
uniform int range;
layout(r16ui) uniform writeonly uimage2D rowDistance;

const int FAR_ROW = 65535;

void main() {
  ivec2 pixel = regionPixel();
  if (any(greaterThanEqual(pixel, imageSize(rowDistance)))) return;
  if (texelOf(focusTiles, pixel >> 5).r == 0u) {
    imageStore(rowDistance, pixel, uvec4(FAR_ROW));
    return;
  }
  int words = sizeOf(focusMask).x;
  int best = FAR_ROW;
  int first = max((pixel.x - range) >> 5, 0), last = min((pixel.x + range) >> 5, words - 1);
  for (int word = first; word <= last; ++word) {
    uint bits = texelOf(focusMask, ivec2(word, pixel.y)).r;
    int begin = word * 32;
    // Nearest set bit at or left of the pixel, and at or right of it.
    int local = pixel.x - begin;
    uint left = local >= 31 ? bits : local < 0 ? 0u : bits & ((2u << local) - 1u);
    uint right = local <= 0 ? bits : local > 31 ? 0u : bits & (~0u << local);
    if (left != 0u) best = min(best, local - findMSB(left));
    if (right != 0u) best = min(best, findLSB(right) - local);
  }
  imageStore(rowDistance, pixel, uvec4(best <= range ? best : FAR_ROW));
}
