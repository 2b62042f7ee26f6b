// Cones stand on a higher level of importance than those whose starts are there already (the interface is described in
// Only.glsl).
#include "lib/None.glsl"

layout(r32f) uniform image2D coneStart;
layout(rg32f) uniform image2D openedHits;  // context hit, and what a ray is opened to

void storeStart(ivec2 pixel, vec2 hit, float start) {
  vec2 opened = vec2(hit.x, start == hit.y ? hit.y : NONE);
  float lower = imageLoad(coneStart, pixel).r;
  vec2 openedBefore = imageLoad(openedHits, pixel).xy;
  if (start == lower) opened.y = max(opened.y, openedBefore.y);
  if (start < lower) opened = openedBefore;
  start = max(start, lower);
  imageStore(openedHits, pixel, vec4(opened, 0.0, 0.0));
  imageStore(coneStart, pixel, vec4(start));
}
