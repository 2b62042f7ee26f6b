// Adaptive sampling: the middles of the sides of a lattice's squares, whose corners and centres are known.
#include "lib/PixelsBetween.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform int halfSide;  // of the lattice's squares, in pixels

// Whether a pixel in the middle of a side needs a ray of its own; otherwise it is interpolated here. `along`: from the pixel
// to the side's end; `aside`: to the square's centre.
bool varies(ivec2 pixel, ivec2 along, ivec2 aside) {
  if (any(greaterThanEqual(pixel, pictureSize))) return false;
  if (any(lessThan(pixel, aside)) || any(greaterThanEqual(pixel + along + aside, pictureSize))) return true;
  ivec2 last = (pictureSize - 1) / (2 * halfSide) * (2 * halfSide);
  vec4 from = known(pixel - along), to = known(pixel + along), centres = known(pixel - aside) + known(pixel + aside);
  vec4 before = known(max(pixel - 3 * along, ivec2(0))), behind = known(min(pixel + 3 * along, last));
  vec4 bend = max(abs(before - 2.0 * from + to), abs(from - 2.0 * to + behind));
  if (most(max(bend, 2.0 * abs(from + to - centres))) > 8.0 * tolerance) return true;
  // Half from the cubic along the side, half from the four pixels around.
  imageStore(focusLayer, pixel, (13.0 / 32.0) * (from + to) - (1.0 / 32.0) * (before + behind) + 0.125 * centres);
  return false;
}

void main() {
  ivec2 corner = 2 * halfSide * regionPixel();
  if (any(greaterThanEqual(corner, pictureSize))) return;
  ivec2 across = ivec2(halfSide, 0), down = ivec2(0, halfSide);
  ivec2 top = corner + across, left = corner + down;
  enlist(bvec2(varies(top, across, down), varies(left, down, across)), top, left);
}
