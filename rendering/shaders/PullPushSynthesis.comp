// Stage 2, one level down: unknown pixels take the biquadratic B-spline refinement of the coarser level (weights 9, 3, 3,
// 1 sixteenths), known ones stay bit for bit.
#include <fine>
#include <schedule>
#include "lib/None.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
TEXELS_2D(r32f, coarse);
layout(r32f) uniform writeonly image2D filled;

void main() {
  ivec2 pixel = regionPixel();
  if (any(greaterThanEqual(pixel, imageSize(filled)))) return;
  float value = fineValue(pixel);
  if (isNone(value)) {
    ivec2 last = sizeOf(coarse) - 1;
    ivec2 nearest = pixel >> 1;
    ivec2 neighbour = clamp(nearest + 2 * (pixel & 1) - 1, ivec2(0), last);
    value = (9.0 * texelOf(coarse, nearest).r +
             3.0 * (texelOf(coarse, ivec2(neighbour.x, nearest.y)).r +
                    texelOf(coarse, ivec2(nearest.x, neighbour.y)).r) +
             texelOf(coarse, neighbour).r) / 16.0;
  }
  imageStore(filled, pixel, vec4(value));
}
