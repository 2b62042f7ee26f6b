#include "rendering/reference/Cells.h"

namespace fenestra::reference {
namespace {

/// a + (b - a)·(w0 + dw·s); a and b of at most second degree.
Cubic mix(const Cubic& a, const Cubic& b, double w0, double dw) {
  Cubic result = a;
  for (std::size_t k = 0; k < 4; ++k) {
    result[k] += (b[k] - a[k]) * w0;
    if (k > 0) result[k] += (b[k - 1] - a[k - 1]) * dw;
  }
  return result;
}

}  // namespace

Cubic alongPiece(const Corners& corners, const Piece& piece) {
  const glm::dvec3 w = piece.begin, dw = piece.end - piece.begin;
  const auto edge = [&](std::size_t i) { return mix({corners[i]}, {corners[i + 1]}, w.x, dw.x); };
  const Cubic front = mix(edge(0), edge(2), w.y, dw.y), back = mix(edge(4), edge(6), w.y, dw.y);
  return mix(front, back, w.z, dw.z);
}

Cubic through(double a, double b, double c, double d) {
  return {a, -5.5 * a + 9.0 * b - 4.5 * c + d, 9.0 * a - 22.5 * b + 18.0 * c - 4.5 * d,
          -4.5 * a + 13.5 * b - 13.5 * c + 4.5 * d};
}

Stops monotoneStops(const Cubic& cubic) {
  Stops stops;
  stops.s[stops.count++] = 0.0;
  // The quadratic's roots in the form that does not cancel (Press et al., Numerical Recipes, §5.6).
  const double a = 3.0 * cubic[3], b = 2.0 * cubic[2], c = cubic[1];
  const double discriminant = b * b - 4.0 * a * c;
  if (discriminant > 0.0) {
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    const double first = std::min(q / a, c / q), second = std::max(q / a, c / q);
    for (const double root : {first, second})
      if (root > 0.0 && root < 1.0) stops.s[stops.count++] = root;
  }
  stops.s[stops.count++] = 1.0;
  return stops;
}

void appendCrossings(const Cubic& cubic, const Stops& stops, double level, std::vector<double>& places) {
  for (std::size_t k = 0; k + 1 < stops.count; ++k) {
    const bool from = evaluate(cubic, stops.s[k]) < level, to = evaluate(cubic, stops.s[k + 1]) < level;
    if (from == to) continue;
    places.push_back(bisect(stops.s[k], stops.s[k + 1], [&](double s) { return (evaluate(cubic, s) < level) == to; }));
  }
}

}  // namespace fenestra::reference
