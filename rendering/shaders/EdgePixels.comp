// Smooth edges, first step: the pixels that edges run through, with their weights, and the picture as it is. What an edge
// is stands in rendering/scene/EdgeRays.h.
#include <schedule>
#include "lib/EdgeList.glsl"
#include "lib/None.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
TEXELS_2D(rgba32f, picture);
layout(rgba32f) uniform writeonly image2D smoothed;
uniform vec2 contrasts;  // from which on a pixel has a weight, and at which it is 1
#if OPENED
TEXELS_2D(rg32f, hitPoints);
TEXELS_2D(r32f, distances);
uniform vec2 widths;  // w_open, w_border in rendered pixels
uniform float outline;  // how many times a contrast counts between rays that do not meet the same
#endif

float differenceOf(vec4 a, vec4 b) {
  vec4 difference = abs(a - b);
  return max(max(difference.r, difference.g), max(difference.b, difference.a));
}

#if OPENED
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
#endif

void main() {
  ivec2 pixel = regionPixel(), size = imageSize(smoothed);
  if (any(greaterThanEqual(pixel, size))) return;
  ivec2 right = min(pixel + ivec2(1, 0), size - 1), below = min(pixel + ivec2(0, 1), size - 1);
  ivec2 left = max(pixel - ivec2(1, 0), ivec2(0)), above = max(pixel - ivec2(0, 1), ivec2(0));
  vec4 here = texelOf(picture, pixel);
  vec4 contrast = vec4(differenceOf(here, texelOf(picture, right)), differenceOf(here, texelOf(picture, below)),
                       differenceOf(here, texelOf(picture, left)), differenceOf(here, texelOf(picture, above)));
  float most = max(max(contrast.x, contrast.y), max(contrast.z, contrast.w));
#if OPENED
  // A loop, and not a condition: machines whose invocations run in step skip it where none needs it.
  for (int once = most * outline > contrasts.x ? 1 : 0; once > 0; --once) {
    uint met = metAt(pixel);
    contrast *= vec4(times(met, metAt(right)), times(met, metAt(below)), times(met, metAt(left)),
                     times(met, metAt(above)));
    most = max(max(contrast.x, contrast.y), max(contrast.z, contrast.w));
  }
#endif
  imageStore(smoothed, pixel, here);
  float weight = clamp((most - contrasts.x) / (contrasts.y - contrasts.x), 0.0, 1.0);
  if (weight > 0.0) {
    uint at = atomicAdd(edgeList.count, 1u);
    if (at < uint(edgeList.pixels.length()))
      edgeList.pixels[at] = uvec2(uint(pixel.x | pixel.y << 16), floatBitsToUint(weight));
  }
}
