// Stage 3, last step: exact Euclidean distance, the minimum over rows of the row distance and the row's own offset.
// Rows are visited outwards and the search ends once the offset alone is no nearer. FAR beyond `range`.
#include <schedule>
#include "lib/None.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
UNSIGNED_TEXELS_2D(r16ui, rowDistance);
UNSIGNED_TEXELS_2D(r8ui, focusTiles);
uniform int range;
layout(r32f) uniform writeonly image2D distances;

void main() {
  ivec2 pixel = regionPixel();
  ivec2 size = imageSize(distances);
  if (any(greaterThanEqual(pixel, size))) return;
  if (texelOf(focusTiles, pixel >> 5).r == 0u) {
    imageStore(distances, pixel, vec4(FAR));
    return;
  }
  const uint unreachable = 0x7fffffffu;
  uint limit = uint(range) * uint(range);
  uint best = unreachable;
  for (int offset = 0; offset <= range && uint(offset * offset) < best; ++offset) {
    for (int side = -1; side <= 1; side += 2) {
      int y = pixel.y + side * offset;
      if (y < 0 || y >= size.y) continue;
      uint across = texelOf(rowDistance, ivec2(pixel.x, y)).r;
      if (across <= uint(range)) best = min(best, across * across + uint(offset * offset));
    }
  }
  imageStore(distances, pixel, vec4(best <= limit ? sqrt(float(best)) : FAR));
}
