// Adaptive sampling: the centres of a lattice's squares.
#include "lib/PixelsBetween.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform int halfSide;  // of the lattice's squares, in pixels

void main() {
  ivec2 square = regionPixel(), last = (pictureSize - 1) / (2 * halfSide);
  ivec2 pixel = (2 * square + 1) * halfSide;
  if (any(greaterThanEqual(pixel, pictureSize))) return;
  // From the lattice's point before the square to the one behind it, along each axis.
  ivec2 at[4];
  for (int i = 0; i < 4; ++i) at[i] = 2 * halfSide * clamp(square + i - 1, ivec2(0), last);
  vec4 corners[4];
  for (int i = 0; i < 4; ++i) corners[i] = known(ivec2(at[1 + (i & 1)].x, at[1 + (i >> 1)].y));
  // The error of linear interpolation half way between two points is an eighth of the second difference, or of half the
  // twist.
  vec4 bend = 0.5 * abs(corners[0] - corners[1] - corners[2] + corners[3]), beyond = vec4(0.0);
  for (int side = 0; side < 4; ++side) {
    int which = side & 1;
    bool down = side > 1;
    vec4 from = corners[down ? which : 2 * which], to = corners[down ? 2 + which : 2 * which + 1];
    vec4 ahead = known(down ? ivec2(at[1 + which].x, at[0].y) : ivec2(at[0].x, at[1 + which].y));
    vec4 past = known(down ? ivec2(at[1 + which].x, at[3].y) : ivec2(at[3].x, at[1 + which].y));
    bend = max(bend, max(abs(ahead - 2.0 * from + to), abs(from - 2.0 * to + past)));
    beyond += ahead + past;
  }
  bool varies = any(equal(square, last)) || most(bend) > 8.0 * tolerance;
  // Coons's patch between the cubics through four points along each side.
  vec4 sum = corners[0] + corners[1] + corners[2] + corners[3];
  if (!varies) imageStore(focusLayer, pixel, (5.0 / 16.0) * sum - (1.0 / 32.0) * beyond);
  enlist(bvec2(varies, false), pixel, pixel);
}
