// Walls stand in the space that the opening removed, before the focus layer (the interface is described in Around.glsl).
#include <schedule>
#include "lib/None.glsl"

TEXELS_2D(rg32f, hitPoints);
TEXELS_2D(r32f, rayStart);

vec2 spanOf(ivec2 pixel) {
  vec2 hit = texelOf(hitPoints, pixel).xy;
  float start = texelOf(rayStart, pixel).r;
  return vec2(hit.x, isNone(hit.x) || !isNone(hit.y) ? -FAR : start);
}
vec4 withWall(vec4 front, vec4 wall) { return wall + (1.0 - wall.a) * front; }
