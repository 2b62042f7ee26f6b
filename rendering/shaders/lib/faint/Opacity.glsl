// What stays is less opaque (the interface is described in None.glsl).
#include "lib/faint/SameShare.glsl"

float faintShare(ivec2 pixel, ivec2 last, vec2 hit) { return faintOpacity; }

vec4 withFaint(vec4 result, ivec2 pixel, float share) {
  vec4 faint = faintAt(pixel, share);
  return faint + (1.0 - faint.a) * result;
}
