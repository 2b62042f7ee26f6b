// Lists the edges between neighbouring pixels that the outline of the focus crosses: one sees it, the other does not.
// They are few among many; in a list, rays that run side by side all have one to solve.
#include "lib/CandidateTiles.glsl"
#include "lib/None.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 4) readonly buffer Hits { vec2 hits[]; };
// An edge's number times two, and one more where its first pixel sees the focus; in no order.
layout(std430, binding = 6) buffer Crossed {
  uint crossedCount;
  uint crossed[];
};

bool sees(uint pixel) { return pixel != NOWHERE && !isNone(hits[pixel].x); }

void main() {
  uint tile = tileOfGroup();
  if (tile >= uint(tileCount)) return;
  ivec2 at = ivec2(gl_LocalInvocationID.xy);
  uint pixel = pixelOf(tile, at);
  bool seen = sees(pixel);
  for (int axis = 0; axis < 2; ++axis)
    if (sees(pixelOf(tile, at + ivec2(1 - axis, axis))) != seen)
      crossed[atomicAdd(crossedCount, 1u)] = 2u * (2u * pixel + uint(axis)) + (seen ? 1u : 0u);
}
