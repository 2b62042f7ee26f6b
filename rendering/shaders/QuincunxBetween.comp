// Adaptive sampling of a quincunx: the pixels between its own.
#include "lib/PixelsBetween.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

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
