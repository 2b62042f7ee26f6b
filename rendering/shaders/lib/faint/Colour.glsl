// What stays is less opaque, and grey (the interface is described in None.glsl).
#include "lib/faint/SameShare.glsl"

float faintShare(ivec2 pixel, ivec2 last, vec2 hit) { return faintOpacity; }

vec4 withFaint(vec4 result, ivec2 pixel, float share) {
  vec4 faint = faintAt(pixel, share);
  faint.rgb = vec3(dot(faint.rgb, vec3(0.2126, 0.7152, 0.0722)));  // ITU-R BT.709
  return faint + (1.0 - faint.a) * result;
}
