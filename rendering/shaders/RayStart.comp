// Stage 4: where each ray starts to see.
#include "lib/Ray.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D hitPoints;
uniform sampler2D focusFilled;
uniform sampler2D distances;
uniform float openWidth;  // rendered pixels
layout(r32f, binding = 0) uniform writeonly image2D rayStart;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, pictureSize))) return;
  vec2 hit = texelFetch(hitPoints, pixel, 0).xy;
  float context = hit.x, focus = hit.y, start = hit.x;
  if (!isNone(context)) {
    float distance = texelFetch(distances, pixel, 0).r;
    if (!isNone(focus)) {
      start = focus;
    } else if (openWidth > 0.0 && distance <= openWidth) {
      start = mix(texelFetch(focusFilled, pixel, 0).r, context, distance / openWidth);
    }
    start = clamp(start, context, max(context, pixelRay(pixel).sOut));
  }
  imageStore(rayStart, pixel, vec4(start));
}
