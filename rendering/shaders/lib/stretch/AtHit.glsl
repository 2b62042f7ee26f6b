// A stretch of a ray of an exploded view lies before or behind the focus's first hit (the interface is described in Whole.glsl).
#include "lib/None.glsl"

uniform sampler2D hitPoints;  // of the picture's rays
uniform int fromHit;          // 1: from the focus's first hit on; 0: up to it
uniform float fromPicture;    // s on the stretch's rays less s on the picture's

vec2 stretchOf(ivec2 pixel) {
  float hit = texelFetch(hitPoints, pixel, 0).y;
  float s = isNone(hit) ? FAR : hit + fromPicture;
  return mix(vec2(-FAR, s), vec2(s, FAR), bvec2(fromHit == 1));
}
