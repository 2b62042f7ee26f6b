// Counts the pixels that show the focus, and the context's edges over it by strength. rendering/scene/ContextLines.h has
// the definition.
#include <schedule>
#include "lib/ContextLines.glsl"
#include "lib/None.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) buffer LineCounts {
  uint pixels;
  uint edges[];  // by strength
} lineCounts;
TEXELS_2D(rg32f, hitPoints);
uniform ivec2 pictureSize;

void main() {
  ivec2 pixel = regionPixel();
  if (any(greaterThanEqual(pixel, pictureSize)) || isNone(texelOf(hitPoints, pixel).y)) return;
  atomicAdd(lineCounts.pixels, 1u);
  vec4 context = texelOf(contextLayer, pixel);
  if (isNone(context.x)) return;
  float strength = lineStrength(bendOf(context.xy), texelOf(silhouette, pixel).r);
  int bins = lineCounts.edges.length();
  atomicAdd(lineCounts.edges[int(clamp(strength * float(bins), 0.0, float(bins - 1)))], 1u);
}
