// How the filled focus blends into the context by the distance map: a part of Blend.glsl and BlendScattered.glsl.
#include "lib/None.glsl"

uniform float openWidth;  // rendered pixels

// What the two maps hold at a pixel's ray.
float distanceAt(ivec2 pixel);
float filledAt(ivec2 pixel);

float uneditedStart(ivec2 pixel, vec2 hit, float sOut) {
  float start = hit.x;
  float distance = distanceAt(pixel);
  if (!isNone(hit.y)) {
    start = hit.y;
  } else if (openWidth > 0.0 && distance <= openWidth) {
    start = mix(filledAt(pixel), hit.x, distance / openWidth);
  }
  return clamp(start, hit.x, max(hit.x, sOut));
}
