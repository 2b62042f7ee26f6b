// Cones, second step: a level of the pyramid from the next finer one.
#include "lib/Cones.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform ivec2 levelSize;     // squares
uniform int finer, coarser;  // where the levels begin

void main() {
  ivec2 at = regionPixel();
  if (any(greaterThanEqual(at, levelSize))) return;
  float deepest = -FAR;
  for (int i = 0; i < 16; ++i) {
    ivec2 from = 4 * at + ivec2(i & 3, i >> 2);
    deepest = max(deepest, coneDepths[finer + from.y * 4 * levelSize.x + from.x]);
  }
  coneDepths[coarser + at.y * levelSize.x + at.x] = deepest;
}
