// Adaptive sampling of the picture (after Levoy, "Volume rendering by adaptive refinement", 1990). Rays are traced through
// a lattice of pixels first. A pixel between lattice points is interpolated where the picture varies smoothly; otherwise it
// is put on a list and gets a ray of its own. First come the centres of the lattice's squares, then the middles of the
// squares' sides, which then have a known pixel on each side. QUINCUNX: every centre has been traced with the lattice.
#include "lib/PixelList.glsl"
#include "lib/Region.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f) uniform image2D focusLayer;
uniform ivec2 pictureSize;
#if !QUINCUNX
uniform int halfSide;     // of the lattice's squares, in pixels
#endif
uniform float tolerance;  // of a colour, 0 … 1

float most(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }
vec4 known(ivec2 pixel) { return imageLoad(focusLayer, pixel); }

#if QUINCUNX

// Whether a pixel off the quincunx needs a ray of its own; otherwise it is interpolated here, with weights for the four
// pixels beside it and the eight a knight's move away that are exact for polynomials of degree 3. The differences of those
// twelve that vanish where the picture is evenly curved tell where it is not: next to a step or a sharp bend the error is an
// eighth to three eighths of the greatest of them, elsewhere far less. A 24th of it is taken for the error.
bool varies(ivec2 pixel) {
  if (any(greaterThanEqual(pixel, pictureSize))) return false;
  if (any(lessThan(pixel, ivec2(2))) || any(greaterThanEqual(pixel + 2, pictureSize))) return true;
  vec4 left = known(pixel + ivec2(-1, 0)), right = known(pixel + ivec2(1, 0));
  vec4 above = known(pixel + ivec2(0, -1)), below = known(pixel + ivec2(0, 1));
  // A knight's move away: 0 to 3 lie two columns and a row off, 4 to 7 a column and two rows; of each four, in this order:
  // above on the left, above on the right, below on the left, below on the right.
  vec4 knights[8], sum = vec4(0.0);
  for (int i = 0; i < 8; ++i) {
    ivec2 way = (ivec2(i, i >> 1) & 1) * 2 - 1;
    knights[i] = known(pixel + (i < 4 ? way * ivec2(2, 1) : way * ivec2(1, 2)));
    sum += knights[i];
  }
  vec4 across = left + right, down = above + below;
  vec4 differs = max(abs(0.5 * (across + down) - 0.25 * sum), abs(across - down));
  // Third differences along the diagonals.
  differs = max(differs, abs(knights[7] - knights[0] + 3.0 * (left - below)));
  differs = max(differs, abs(knights[3] - knights[4] + 3.0 * (above - right)));
  differs = max(differs, abs(knights[5] - knights[2] + 3.0 * (left - above)));
  differs = max(differs, abs(knights[1] - knights[6] + 3.0 * (below - right)));
  if (most(differs) > 24.0 * tolerance) return true;
  imageStore(focusLayer, pixel, (5.0 / 16.0) * (across + down) - (1.0 / 32.0) * sum);
  return false;
}

void main() {
  ivec2 corner = 2 * regionPixel();
  if (any(greaterThanEqual(corner, pictureSize))) return;
  ivec2 top = corner + ivec2(1, 0), left = corner + ivec2(0, 1);
  enlist(bvec2(varies(top), varies(left)), top, left);
}

#elif CENTRES

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

#else

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

#endif
