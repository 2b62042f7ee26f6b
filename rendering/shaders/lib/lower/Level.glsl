// The map holds the hits of the levels below: rays that miss the level stay opened to those (the interface is described in
// None.glsl).
#include "lib/None.glsl"

layout(rg32f) uniform image2D importantHits;

float orBelow(float hit, ivec2 pixel) {
  if (isNone(hit)) hit = imageLoad(importantHits, pixel).y;
  return hit;
}
