// Stage 2, one level up: mean of the known pixels of each 2×2 block (Strengert, Kraus, Ertl, VMV 2006).
#include <fine>
#include <schedule>
#include "lib/None.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(r32f) uniform writeonly image2D coarse;

void main() {
  ivec2 pixel = regionPixel();
  if (any(greaterThanEqual(pixel, imageSize(coarse)))) return;
  ivec2 size = sizeOf(fine);
  float sum = 0.0, known = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 at = 2 * pixel + ivec2(i & 1, i >> 1);
    if (any(greaterThanEqual(at, size))) continue;
    float value = fineValue(at);
    if (!isNone(value)) {
      sum += value;
      known += 1.0;
    }
  }
  imageStore(coarse, pixel, vec4(known > 0.0 ? sum / known : NONE));
}
