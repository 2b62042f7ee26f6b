// Stage 4: where each ray starts to see.
#include <edits>
#include <schedule>
#include <starts>
#include "lib/None.glsl"
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(r32f) uniform writeonly image2D rayStart;
TEXELS_2D(rg32f, hitPoints);

void main() {
  ivec2 pixel = regionPixel();
  if (!hasRay(pixel)) return;
  vec2 hit = texelOf(hitPoints, pixel).xy;
  float start = hit.x;
  if (!isNone(hit.x)) {
    float sOut = pixelRay(pixel).sOut;
    start = uneditedStart(pixel, hit, sOut);
    if (EDITED) start = clamp(start + editAt(pixel).x, hit.x, max(hit.x, isNone(hit.y) ? sOut : hit.y));
  }
  imageStore(rayStart, pixel, vec4(start));
  storeBorder(pixel, hit);
}
