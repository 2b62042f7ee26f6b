// Where an opening is cut, the outlines of what rays meet count more, and the line around the opening not at all (the interface
// is described in Plain.glsl).
#include <schedule>
#include "lib/None.glsl"
#include "lib/edges/Contrasts.glsl"

TEXELS_2D(rg32f, hitPoints);
TEXELS_2D(r32f, distances);
uniform vec2 widths;  // w_open, w_border in rendered pixels
uniform float outline;  // how many times a contrast counts between rays that do not meet the same

// What the ray of a pixel meets, 1: the context, 2: the focus, or both; with 4 where the line around the opening covers a
// part of the pixel.
uint metAt(ivec2 pixel) {
  vec2 hit = texelOf(hitPoints, pixel).xy;
  float distance = texelOf(distances, pixel).r;
  bool covered = distance > 0.0 && min(distance + 0.5, widths.x + widths.y) > max(distance - 0.5, widths.x);
  return (isNone(hit.x) ? 0u : covered ? 5u : 1u) | (isNone(hit.y) ? 0u : 2u);
}

float times(uint a, uint b) {
  bool isOutline = ((a ^ b) & 3u) != 0u, onLine = ((a | b) & 4u) != 0u;
  return isOutline ? outline : onLine ? 0.0 : 1.0;
}

float greatestContrast(vec4 contrast, ivec2 pixel, ivec2 beside[4]) {
  float most = highest(contrast);
  // A loop, and not a condition: machines whose invocations run in step skip it where none needs it.
  for (int once = most * outline > contrasts.x ? 1 : 0; once > 0; --once) {
    uint met = metAt(pixel);
    contrast *= vec4(times(met, metAt(beside[0])), times(met, metAt(beside[1])), times(met, metAt(beside[2])),
                     times(met, metAt(beside[3])));
    most = highest(contrast);
  }
  return most;
}
