// Colour and opacity of a piece of a ray.
//
// Emission–absorption along a piece of length l: C = ∫ e(x) exp(-∫ k) dx, with emission e and extinction k (1/mm). For
// one material that is e/k · (1 - exp(-k·l)), and the opacity 1 - exp(-k·l). Where values change evenly along the piece,
// its mean material stands for all of it (pre-integrated classification without attenuation inside the piece: Engel,
// Kraus, Ertl 2001).

vec4 over(vec4 front, vec4 back) { return front + (1.0 - front.a) * back; }

// (1 - exp(-x)) / x, by its series where the difference would cancel.
float relativeOpacity(float x) { return x < 1e-2 ? 1.0 - x * (0.5 - x * (1.0 / 6.0)) : (1.0 - exp(-x)) / x; }

// A premultiplied piece under a light. Shaded colour = colour · light.x + light.y.
vec4 litBy(vec4 piece, vec2 light) { return vec4(piece.rgb * light.x + piece.a * light.y, piece.a); }

// Premultiplied colour and opacity of a piece of ray of one material.
vec4 pieceOf(vec4 material, float lengthOfPiece, vec2 light) {
  return litBy(material, light) * (lengthOfPiece * relativeOpacity(material.a * lengthOfPiece));
}

// Where in a piece of one material what is seen of it comes from on average, 0 to 1 from its front: ∫ x exp(-depth·x) dx
// over ∫ exp(-depth·x) dx. Light that changes evenly along a piece is there what it is on average.
float centreOfEmission(float depth) {
  float passed = exp(-depth);  // as relativeOpacity() has it: one exponential for both
  return depth < 0.1 ? 0.5 - depth / 12.0 : 1.0 / depth - passed / (1.0 - passed);
}

// The mean and the variance of those positions where the extinction changes evenly, by `growth` times its mean (-2 to 2)
// from front to back: exact for small depths and for no growth, the mean to first order in the growth.
vec2 momentsOfEmission(float depth, float growth) {
  float passed = exp(-depth), absorbed = 1.0 - passed, mean, variance, shift;
  if (depth < 0.3) {
    float square = depth * depth;
    mean = 0.5 - depth * (1.0 / 12.0 - square * (1.0 / 720.0));
    variance = 1.0 / 12.0 - square * (1.0 / 240.0);
    shift = 1.0 / 12.0 - square * (1.0 / 720.0);
  } else {
    float inverse = 1.0 / depth, ratio = passed / absorbed;
    mean = inverse - ratio;
    variance = inverse * inverse - ratio / absorbed;
    shift = 0.5 * (depth - 2.0 + (depth + 2.0) * passed) * inverse * inverse / absorbed;
  }
  return vec2(clamp(mean + growth * shift, 0.0, 1.0), variance * (1.0 - growth * growth * (1.0 / 12.0)));
}
