// Stage 3, second step: for each tile of 32×32 pixels, whether the focus projection comes within `reach` tiles of it.
// Pixels of other tiles are out of range and need no search.
#include <schedule>
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
UNSIGNED_TEXELS_2D(r32ui, focusMask);
uniform int reach;
layout(r8ui) uniform writeonly uimage2D focusTiles;

void main() {
  ivec2 tile = regionPixel();
  if (any(greaterThanEqual(tile, imageSize(focusTiles)))) return;
  ivec2 size = sizeOf(focusMask);  // a word is a tile wide
  ivec2 low = max(ivec2(tile.x - reach, (tile.y - reach) * 32), ivec2(0));
  ivec2 high = min(ivec2(tile.x + reach, (tile.y + reach) * 32 + 31), size - 1);
  uint any = 0u;
  for (int y = low.y; y <= high.y && any == 0u; ++y)
    for (int x = low.x; x <= high.x; ++x) any |= texelOf(focusMask, ivec2(x, y)).r;
  imageStore(focusTiles, tile, uvec4(any != 0u ? 1u : 0u));
}
