// Stage 1: first context-or-focus hit (x) and first focus hit (y) of every pixel's ray, as s (see lib/Ray.glsl).
#include "lib/Ray.glsl"
#include "lib/Volume.glsl"
#include "lib/Crossing.glsl"
#include "lib/FocusIndex.glsl"
#include "lib/FirstHit.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rg32f, binding = 0) uniform writeonly image2D hitPoints;
uniform ivec2 pixelOffset;  // first pixel of the region, for a look at a single one

void main() {
  ivec2 local = ivec2(gl_GlobalInvocationID.xy);
  ivec2 pixel = local + pixelOffset;
  if (any(greaterThanEqual(local, imageSize(hitPoints))) || any(greaterThanEqual(pixel, pictureSize))) return;
  Ray ray = pixelRay(pixel);
  float focus = NONE;
  if (ray.sIn <= ray.sOut) {
#if FOCUS_KIND != 0
    focus = firstFocusHit(ray);
#endif
    float context = firstContextHit(ray, isNone(focus) ? ray.sOut : focus);
    if (isNone(context)) context = focus;
    imageStore(hitPoints, local, vec4(context, focus, 0.0, 0.0));
  } else {
    imageStore(hitPoints, local, vec4(NONE, NONE, 0.0, 0.0));
  }
}
