// All stays on some of the pixels, and nothing on the others (the interface is described in None.glsl).
#include "lib/faint/SameShare.glsl"

// Bayer's matrix of 8×8.
float faintShare(ivec2 pixel, ivec2 last, vec2 hit) {
  int odd = pixel.x ^ pixel.y, rank = 0;
  for (int bit = 0; bit < 3; ++bit) rank = (rank << 2) | (((odd >> bit) & 1) << 1) | ((pixel.y >> bit) & 1);
  return (float(rank) + 0.5) / 64.0 < faintOpacity ? 1.0 : 0.0;
}

vec4 withFaint(vec4 result, ivec2 pixel, float share) {
  vec4 faint = faintAt(pixel, share);
  return faint + (1.0 - faint.a) * result;
}
