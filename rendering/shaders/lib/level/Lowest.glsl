// Cones stand on the lowest of several levels of importance (the interface is described in Only.glsl).
#include "lib/None.glsl"

layout(r32f) uniform writeonly image2D coneStart;
layout(rg32f) uniform writeonly image2D openedHits;  // context hit, and what a ray is opened to

void storeStart(ivec2 pixel, vec2 hit, float start) {
  vec2 opened = vec2(hit.x, start == hit.y ? hit.y : NONE);
  imageStore(openedHits, pixel, vec4(opened, 0.0, 0.0));
  imageStore(coneStart, pixel, vec4(start));
}
