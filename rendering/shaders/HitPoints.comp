// Stage 1: first context-or-focus hit (x) and first focus hit (y) of every pixel's ray, as s (see lib/PixelRay.glsl).
#include "lib/FirstHit.glsl"
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rg32f) uniform writeonly image2D hitPoints;
uniform ivec2 pixelOffset;  // first pixel of the region, for a look at a single one

void main() {
  ivec2 local = regionPixel();
  ivec2 pixel = local + pixelOffset;
  if (any(greaterThanEqual(local, imageSize(hitPoints))) || !hasRay(pixel)) return;
  Ray ray = pixelRay(pixel);
  vec2 hits = vec2(NONE);  // context or focus, focus
  if (ray.sIn <= ray.sOut) {
    hits.y = firstFocusHit(ray);
    hits.x = firstContextHit(ray, isNone(hits.y) ? ray.sOut : hits.y);
    if (isNone(hits.x)) hits.x = hits.y;
  }
  imageStore(hitPoints, local, vec4(hits, 0.0, 0.0));
}
