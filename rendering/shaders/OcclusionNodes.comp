// The medium that casts shadows, last step: the shares of light that reach four centres of cells in a texel, as
// lib/occlusion/Nodes.glsl reads it. An invocation a cell: x, and y and z one below the other.
#include <schedule>
#include "lib/Region.glsl"
#include "lib/Uniforms.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
UNSIGNED_TEXELS_2D(r32ui, nodeValues);
layout(rgba32ui) uniform writeonly uimage2D occlusionNodes;

void main() {
  ivec2 pixel = regionPixel();
  if (pixel.x >= occlusion.dims.x || pixel.y >= occlusion.dims.y * occlusion.dims.z) return;
  bool lastX = pixel.x + 1 == occlusion.dims.x, lastY = pixel.y % occlusion.dims.y + 1 == occlusion.dims.y;
  ivec2 x = ivec2(lastX ? 0 : 1, 0), y = ivec2(0, lastY ? 0 : 1);
  imageStore(occlusionNodes, pixel, uvec4(texelOf(nodeValues, pixel).r, texelOf(nodeValues, pixel + x).r,
                                          texelOf(nodeValues, pixel + y).r, texelOf(nodeValues, pixel + x + y).r));
}
