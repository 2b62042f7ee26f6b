// Stage 4: where each ray starts to see.
#include "lib/Region.glsl"
#include "lib/PixelRay.glsl"
#include "lib/opening/RayStart.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(r32f) uniform writeonly image2D rayStart;
#if EDITED
TEXELS_2D(rg32f, editMap);
#endif
#if SCATTERED
layout(r32f) uniform writeonly image2D borderDistance;  // that the line around the opening goes by: 0 on the focus
#endif

void main() {
  ivec2 pixel = regionPixel();
  if (!hasRay(pixel)) return;
  vec2 hit = texelOf(hitPoints, pixel).xy;
  float start = hit.x;
  if (!isNone(hit.x)) {
    float sOut = pixelRay(pixel).sOut;
    start = uneditedStart(pixel, hit, sOut);
#if EDITED
    start = clamp(start + texelOf(editMap, pixel).r, hit.x, max(hit.x, isNone(hit.y) ? sOut : hit.y));
#endif
  }
  imageStore(rayStart, pixel, vec4(start));
#if SCATTERED
  imageStore(borderDistance, pixel, vec4(isNone(hit.y) ? distanceAt(pixel) : 0.0));
#endif
}
