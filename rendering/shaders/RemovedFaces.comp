// Stage 4 where another camera cuts the opening, first step: that camera's picture as depths behind its anchor plane, mm.
// Output: where its rays start, where they meet the context, the filled focus (each NONE where there is nothing), and the
// distance map in pixels, up to `reach`.
#include <schedule>
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform writeonly image2D faces;
TEXELS_2D(rg32f, hitPoints);
TEXELS_2D(r32f, rayStart);
TEXELS_2D(r32f, focusFilled);
TEXELS_2D(r32f, distances);
uniform float reach;

float depthOr(ivec2 pixel, float s) { return isNone(s) ? NONE : depthAtPosition(pixel, s); }

void main() {
  ivec2 pixel = regionPixel();
  if (any(greaterThanEqual(pixel, rays.pictureSize))) return;
  imageStore(faces, pixel, vec4(depthOr(pixel, texelOf(rayStart, pixel).r), depthOr(pixel, texelOf(hitPoints, pixel).x),
                                depthOr(pixel, texelOf(focusFilled, pixel).r),
                                min(texelOf(distances, pixel).r, reach)));
}
