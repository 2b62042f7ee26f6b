// An opening removes what a picture's rays do not see (the interface is described in Closed.glsl).
#include <schedule>
#include "lib/None.glsl"
#include "lib/PixelRay.glsl"
#include "lib/Uniforms.glsl"

TEXELS_2D(rg32f, hitPoints);
TEXELS_2D(r32f, rayStart);

float visibleShare(vec3 place) {
  vec3 point = occluders.viewFromCells * place + occluders.offset;
  vec2 ndc = point.xy / (rays.halfSize * (1.0 + point.z * occluders.perDepth));
  ivec2 pixel = ivec2(floor(vec2(rays.pictureSize) * (0.5 + 0.5 * vec2(ndc.x, -ndc.y))));
  bool shown = point.z >= occluders.nearest && all(greaterThanEqual(pixel, ivec2(0))) &&
               all(lessThan(pixel, rays.pictureSize));
  if (!shown) return 1.0;
  float start = texelOf(rayStart, pixel).r, context = texelOf(hitPoints, pixel).x;
  if (isNone(start)) return 1.0;
  float open = clamp((start - context) / occluders.width, 0.0, 1.0);
  return 1.0 - open * clamp((start - positionAtDepth(pixel, point.z)) / occluders.width + 0.5, 0.0, 1.0);
}
