// Smooth edges, first step: the pixels that edges run through, with their weights, and the picture as it is. What an edge
// is stands in rendering/scene/EdgeRays.h.
#include <edges>
#include <schedule>
#include "lib/EdgeList.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
TEXELS_2D(rgba32f, picture);
layout(rgba32f) uniform writeonly image2D smoothed;

float differenceOf(vec4 a, vec4 b) {
  vec4 difference = abs(a - b);
  return max(max(difference.r, difference.g), max(difference.b, difference.a));
}

void main() {
  ivec2 pixel = regionPixel(), size = imageSize(smoothed);
  if (any(greaterThanEqual(pixel, size))) return;
  ivec2 right = min(pixel + ivec2(1, 0), size - 1), below = min(pixel + ivec2(0, 1), size - 1);
  ivec2 left = max(pixel - ivec2(1, 0), ivec2(0)), above = max(pixel - ivec2(0, 1), ivec2(0));
  vec4 here = texelOf(picture, pixel);
  vec4 contrast = vec4(differenceOf(here, texelOf(picture, right)), differenceOf(here, texelOf(picture, below)),
                       differenceOf(here, texelOf(picture, left)), differenceOf(here, texelOf(picture, above)));
  float most = greatestContrast(contrast, pixel, ivec2[4](right, below, left, above));
  imageStore(smoothed, pixel, here);
  float weight = clamp((most - contrasts.x) / (contrasts.y - contrasts.x), 0.0, 1.0);
  if (weight > 0.0) {
    uint at = atomicAdd(edgeList.count, 1u);
    if (at < uint(edgeList.pixels.length()))
      edgeList.pixels[at] = uvec2(uint(pixel.x | pixel.y << 16), floatBitsToUint(weight));
  }
}
