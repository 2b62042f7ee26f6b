// Where rays first meet labels of a level of importance or more, in place of the focus hits of stage 1; `<focus>` is the
// index of those labels. Output: the context hit of stage 1 (x), and that one, not before it (y).
#include <lower>
#include <schedule>
#include "lib/FirstHit.glsl"
#include "lib/PixelRay.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
TEXELS_2D(rg32f, hitPoints);

void main() {
  ivec2 pixel = regionPixel();
  if (!hasRay(pixel)) return;
  Ray ray = pixelRay(pixel);
  float context = texelOf(hitPoints, pixel).x, hit = NONE;
  if (!isNone(context) && ray.sIn <= ray.sOut) {
    hit = firstFocusHit(ray);
    if (!isNone(hit)) hit = max(hit, context);
  }
  imageStore(importantHits, pixel, vec4(context, orBelow(hit, pixel), 0.0, 0.0));
}
