// Stage 4 without the brush: where a ray starts to see. With GIVEN_START, as another pass has found it.
#include <schedule>
#include "lib/None.glsl"
#include "lib/PixelRay.glsl"

TEXELS_2D(rg32f, hitPoints);
#if GIVEN_START
TEXELS_2D(r32f, givenStart);

float uneditedStart(ivec2 pixel, vec2 hit, float sOut) { return texelOf(givenStart, pixel).r; }
#else
TEXELS_2D(r32f, focusFilled);
TEXELS_2D(r32f, distances);
uniform float openWidth;  // rendered pixels

#if SCATTERED
// Between the centres of pixels (rendering/scene/EdgeRays.h).
uniform float reach;  // rendered pixels: greater distances count as this

float bilinear(vec4 corners, vec2 at) {
  vec2 rows = mix(corners.xz, corners.yw, at.x);
  return mix(rows.x, rows.y, at.y);
}
ivec2 cornerOf(ivec2 first, int i) {
  return clamp(first + ivec2(i & 1, i >> 1), ivec2(0), rays.pictureSize - 1);
}
float distanceAt(ivec2 pixel) {
  vec2 texel = placeOf(pixel) - 0.5, first = floor(texel);
  vec4 corners;
  for (int i = 0; i < 4; ++i) corners[i] = min(texelOf(distances, cornerOf(ivec2(first), i)).r, reach);
  return bilinear(corners, texel - first);
}
float filledAt(ivec2 pixel) {
  vec2 texel = placeOf(pixel) - 0.5, first = floor(texel);
  vec4 corners;
  for (int i = 0; i < 4; ++i) corners[i] = texelOf(focusFilled, cornerOf(ivec2(first), i)).r;
  return bilinear(corners, texel - first);
}
#else
float distanceAt(ivec2 pixel) { return texelOf(distances, pixel).r; }
float filledAt(ivec2 pixel) { return texelOf(focusFilled, pixel).r; }
#endif

// `hit`: context and focus hit of the pixel, the first not NONE. sOut: where its ray leaves the box.
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
#endif
