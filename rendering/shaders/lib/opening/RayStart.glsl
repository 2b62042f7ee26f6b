// Stage 4 without the brush: where a ray starts to see. With GIVEN_START, as another pass has found it.
#include <schedule>
#include "lib/None.glsl"

TEXELS_2D(rg32f, hitPoints);
#if GIVEN_START
TEXELS_2D(r32f, givenStart);

float uneditedStart(ivec2 pixel, vec2 hit, float sOut) { return texelOf(givenStart, pixel).r; }
#else
TEXELS_2D(r32f, focusFilled);
TEXELS_2D(r32f, distances);
uniform float openWidth;  // rendered pixels

// `hit`: context and focus hit of the pixel, the first not NONE. sOut: where its ray leaves the box.
float uneditedStart(ivec2 pixel, vec2 hit, float sOut) {
  float start = hit.x;
  float distance = texelOf(distances, pixel).r;
  if (!isNone(hit.y)) {
    start = hit.y;
  } else if (openWidth > 0.0 && distance <= openWidth) {
    start = mix(texelOf(focusFilled, pixel).r, hit.x, distance / openWidth);
  }
  return clamp(start, hit.x, max(hit.x, sOut));
}
#endif
