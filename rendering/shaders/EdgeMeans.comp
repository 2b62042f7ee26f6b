// Smooth edges, last step: the pixels of a batch become means of their centre's ray and of those between
// (rendering/scene/EdgeRays.h).
#include <schedule>
#include "lib/EdgeList.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
TEXELS_2D(rgba32f, picture);
TEXELS_2D(rgba32f, drawn);  // by the rays between
layout(rgba32f) uniform writeonly image2D smoothed;

void main() {
  ivec2 block = regionPixel();
  int edge = block.y * BLOCKS_ACROSS + block.x;
  if (block.x >= BLOCKS_ACROSS || edge >= edgeCount) return;
  ivec2 pixel = edgePixel(edge);
  float weight = uintBitsToFloat(edgeList.pixels[uint(firstEdge + edge)].y);
  vec4 centre = texelOf(picture, pixel), sum = centre;
  for (int i = 0; i < 4; ++i) sum += texelOf(drawn, 2 * block + ivec2(i & 1, i >> 1));
  imageStore(smoothed, pixel, mix(centre, 0.2 * sum, weight));
}
