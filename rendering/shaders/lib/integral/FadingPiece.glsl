// Colour and opacity of a piece of a ray in a context that fades.
//
// With the optical depth τ so far, T = exp(-τ), κ the extinction and f = fadeOf() along the piece,
//
//   τ' = κ 2^(f T^sharpness),   C' = T τ' c
//
// τ is found by the classical Runge-Kutta method of fourth order in one step, which asks κ and f at both ends and in the
// middle. The colour c is a parabola through three points, weighted by what is seen of it: by the mean and the variance
// of an extinction that changes evenly from front to back, of the same depth (lib/integral/Piece.glsl). Where f, κ and c
// do not change, and the piece is thin or f is 0, that is exact.
//
// Around a focal region, and in a ghost, the factor is 2^f on one side of a border and 1 on the other, whatever τ is: the
// method is Simpson's rule then. A piece lies on one side of such a border.
#include <fading>
#include "lib/integral/Piece.glsl"

struct FadingPoint {
  float extinction;  // 1/mm
  float fade;
  vec3 colour;       // lit
};

// `passed`: T^sharpness in front of the piece.
float fadedExtinction(FadingPoint point, float passed) { return point.extinction * exp2(point.fade * passed); }

// Premultiplied; `transmittance`: in front of the piece; `fades`: 0 where the piece shows as it is, else 1.
vec4 pieceOf(FadingPoint front, FadingPoint middle, FadingPoint back, float lengthOfPiece, float transmittance,
             float fades) {
  float sharpness = sharpnessOfFade(), passed = FOLLOWS_LIGHT ? pow(transmittance, sharpness) : fades;
  float first = lengthOfPiece * fadedExtinction(front, passed);
  float second = lengthOfPiece * fadedExtinction(middle, passed * exp(-0.5 * sharpness * first));
  float third = lengthOfPiece * fadedExtinction(middle, passed * exp(-0.5 * sharpness * second));
  float fourth = lengthOfPiece * fadedExtinction(back, passed * exp(-sharpness * third));
  float depth = min((first + 2.0 * (second + third) + fourth) * (1.0 / 6.0), 1e6);
  float last = lengthOfPiece * fadedExtinction(back, passed * exp(-sharpness * depth));
  float growth = clamp((last - first) / max(depth, 1e-30), -2.0, 2.0);
  vec2 moments = momentsOfEmission(depth, growth);
  float x = moments.x, square = moments.y + x * x;
  vec3 colour = front.colour * (1.0 - 3.0 * x + 2.0 * square) + middle.colour * (4.0 * (x - square)) +
                back.colour * (2.0 * square - x);
  return vec4(max(colour, 0.0), 1.0) * (depth * relativeOpacity(depth));
}

// From both ends alone, by the rule of the trapezium, where what lies before a point decides.
vec4 pieceOf(FadingPoint front, FadingPoint back, float lengthOfPiece, float transmittance) {
  float sharpness = sharpnessOfFade(), passed = pow(transmittance, sharpness);
  float first = lengthOfPiece * fadedExtinction(front, passed);
  float last = lengthOfPiece * fadedExtinction(back, passed * exp(-sharpness * first));
  float depth = min(0.5 * (first + last), 1e6);
  return vec4(0.5 * (front.colour + back.colour), 1.0) * (depth * relativeOpacity(depth));
}
