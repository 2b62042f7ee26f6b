// Stage 4 before the brush, between the centres of pixels (rendering/scene/EdgeRays.h; the interface is described in
// Blend.glsl).
#include <schedule>
#include "lib/Bilinear.glsl"
#include "lib/None.glsl"
#include "lib/PixelRay.glsl"
#include "lib/starts/BlendedStart.glsl"

TEXELS_2D(r32f, focusFilled);
TEXELS_2D(r32f, distances);
uniform float reach;  // rendered pixels: greater distances count as this

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

layout(r32f) uniform writeonly image2D borderDistance;  // 0 on the focus

void storeBorder(ivec2 pixel, vec2 hit) {
  imageStore(borderDistance, pixel, vec4(isNone(hit.y) ? distanceAt(pixel) : 0.0));
}
