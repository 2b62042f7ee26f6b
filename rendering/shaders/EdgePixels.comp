// Smooth edges, first step: the pixels that edges run through, with their weights, and the picture as it is. What an edge
// is stands in rendering/scene/Edges.h.
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
#endif

struct Seen {
  vec4 colour;
  uint met;       // 1: the context, 2: the focus, or both
  uint onBorder;  // 1: the line around the opening covers a part of the pixel
};

Seen seenAt(ivec2 pixel) {
  Seen seen = Seen(texelOf(picture, pixel), 0u, 0u);
#if OPENED
  vec2 hit = texelOf(hitPoints, pixel).xy;
  float distance = texelOf(distances, pixel).r;
  bool covered = distance > 0.0 && min(distance + 0.5, widths.x + widths.y) > max(distance - 0.5, widths.x);
  seen.met = (isNone(hit.x) ? 0u : 1u) | (isNone(hit.y) ? 0u : 2u);
  seen.onBorder = covered && !isNone(hit.x) ? 1u : 0u;
#endif
  return seen;
}

float contrastBetween(Seen a, Seen b) {
  vec4 difference = abs(a.colour - b.colour);
  float contrast = max(max(difference.r, difference.g), max(difference.b, difference.a));
  bool isSmooth = a.met == b.met && (a.onBorder | b.onBorder) != 0u;
  return isSmooth ? 0.0 : contrast;
}

void main() {
  ivec2 pixel = regionPixel(), size = imageSize(smoothed);
  if (any(greaterThanEqual(pixel, size))) return;
  Seen here = seenAt(pixel);
  float contrast = contrastBetween(here, seenAt(min(pixel + ivec2(1, 0), size - 1)));
  contrast = max(contrast, contrastBetween(here, seenAt(min(pixel + ivec2(0, 1), size - 1))));
  contrast = max(contrast, contrastBetween(here, seenAt(max(pixel - ivec2(1, 0), ivec2(0)))));
  contrast = max(contrast, contrastBetween(here, seenAt(max(pixel - ivec2(0, 1), ivec2(0)))));
  imageStore(smoothed, pixel, here.colour);
  float weight = clamp((contrast - contrasts.x) / (contrasts.y - contrasts.x), 0.0, 1.0);
  if (weight > 0.0) {
    uint at = atomicAdd(edgeList.count, 1u);
    if (at < uint(edgeList.pixels.length()))
      edgeList.pixels[at] = uvec2(uint(pixel.x | pixel.y << 16), floatBitsToUint(weight));
  }
}
