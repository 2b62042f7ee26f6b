// Colour and opacity of a piece of a ray in a context that fades the less the more opaque the ray is already.
//
// With the optical depth τ so far, T = exp(-τ), κ the extinction and f = fadeAt() along the piece,
//
//   τ' = κ 2^(f T^sharpness),   C' = T τ' c
//
// τ is found by the classical Runge-Kutta method of fourth order in one step, which asks κ and f at both ends and in the
// middle. The colour c is a parabola through three points, weighted by what is seen of it: by the mean and the variance
// of an extinction that changes evenly from front to back, of the same depth (lib/integral/Piece.glsl). Where f, κ and c
// do not change, and the piece is thin or f is 0, that is exact.
//
// Around a focal region, and of a ghost, the factor is 2^f on one side of a border and 1 on the other, whatever τ is: the
// method is Simpson's rule then. A piece lies on one side of such a border.
#include "lib/Fading.glsl"
#include "lib/integral/Piece.glsl"
#if FADING

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
#if FADING > 1
  const float sharpness = 0.0;
  float passed = fades;
#else
  float sharpness = fading.sharpness, passed = pow(transmittance, sharpness);
#endif
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

#if FADING == 1
// The same from both ends alone, by the rule of the trapezium.
vec4 pieceOf(FadingPoint front, FadingPoint back, float lengthOfPiece, float transmittance) {
  float passed = pow(transmittance, fading.sharpness), first = lengthOfPiece * fadedExtinction(front, passed);
  float last = lengthOfPiece * fadedExtinction(back, passed * exp(-fading.sharpness * first));
  float depth = min(0.5 * (first + last), 1e6);
  return vec4(0.5 * (front.colour + back.colour), 1.0) * (depth * relativeOpacity(depth));
}
#endif
#endif
