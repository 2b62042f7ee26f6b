// Where along a segment of two halves its light is taken: in one place of the half of which less is seen, in two of the
// other. Each place is the centre of what is seen of its part, where light that changes evenly has its mean. Extinction is
// taken to change evenly along the segment.
#include "lib/PreIntegration.glsl"

// Places along a segment, 0 at its front to 1 at its back.
struct LightPlaces {
  bool behind;  // more is seen of the half behind
  float minor;  // in the half of which less is seen
  vec2 major;   // in the quarters of the other
  float share;  // of what is seen of those, how much is of the first
};

// centreOfEmission() by a rational function with the same limits, within 0.015 of it: an exponential and a division less.
float nearCentreOfEmission(float depth) { return (6.0 + 0.674 * depth) / (12.0 + depth * (3.348 + 0.674 * depth)); }

LightPlaces lightPlaces(Segment first, Segment second) {
  LightPlaces places;
  vec2 depths = vec2(first.depth, second.depth), opacities = vec2(first.piece.a, second.piece.a);
  // From front to back of each half, as shares of its mean.
  vec2 growths = clamp((depths.y - depths.x) / max(depths, 1e-30), -2.0, 2.0);
  places.behind = (1.0 - opacities.x) * opacities.y > opacities.x;
  if (places.behind) {
    depths = depths.yx;
    opacities = opacities.yx;
    growths = growths.yx;
  }
  float from = places.behind ? 0.5 : 0.0;
  places.minor = 0.5 - from + 0.5 * (nearCentreOfEmission(depths.y) + growths.y * (1.0 / 12.0));
  float firstDepth = depths.x * (0.5 - 0.125 * growths.x);
  places.major = from + vec2(0.0, 0.25) + 0.25 * vec2(nearCentreOfEmission(firstDepth),
                                                      nearCentreOfEmission(depths.x - firstDepth));
  places.share = opacityOf(firstDepth) / max(opacities.x, 1e-30);
  return places;
}
