// Cones, second step: a level of the pyramid from the next finer one.
#include "lib/Cones.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform int below;  // levels that it lies below the top

void main() {
  ivec2 at = regionPixel(), squares = cones.tops << below;
  if (any(greaterThanEqual(at, squares))) return;
  int row = 2 * squares.x, first = coneLevel(below + 1) + 2 * at.y * row + 2 * at.x;
  coneDepths[coneLevel(below) + at.y * squares.x + at.x] =
      max(max(coneDepths[first], coneDepths[first + 1]), max(coneDepths[first + row], coneDepths[first + row + 1]));
}
