// Stage 4: where each ray starts to see.
#include "lib/Region.glsl"
#include "lib/Ray.glsl"
#include "lib/RayStart.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(r32f, binding = 0) uniform writeonly image2D rayStart;
#if EDITED
layout(rg32f) uniform readonly image2D editMap;
#endif

void main() {
  ivec2 pixel = regionPixel();
  if (any(greaterThanEqual(pixel, pictureSize))) return;
  vec2 hit = imageLoad(hitPoints, pixel).xy;
  float start = hit.x;
  if (!isNone(hit.x)) {
    float sOut = pixelRay(pixel).sOut;
    start = uneditedStart(pixel, hit, sOut);
#if EDITED
    start = clamp(start + imageLoad(editMap, pixel).r, hit.x, max(hit.x, isNone(hit.y) ? sOut : hit.y));
#endif
  }
  imageStore(rayStart, pixel, vec4(start));
}
