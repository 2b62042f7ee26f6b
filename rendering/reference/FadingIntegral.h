#pragma once
// The volume rendering integral through a context that fades (MethodStages::Fading in
// rendering/vocabulary/MethodStages.h): a system of differential equations, solved step by step.
//
// With the optical depth τ along a ray, A = 1 - exp(-τ), and t in mm,
//
//   τ' = κ g^(p exp(-sharpness τ)),   p = (reach · s · (1 - d))^sharpness
//   C' = exp(-τ) τ' c
//
// by the pair of Runge-Kutta formulas of fifth and fourth order of J. R. Dormand, P. J. Prince: A family of embedded
// Runge-Kutta formulae, Journal of Computational and Applied Mathematics 6(1), 1980. Each step is shortened until the
// difference of the two is small enough. An error δ of τ grows with δ' = (∂τ'/∂τ) δ, and ∂τ'/∂τ ≥ 0: the more opaque a
// ray is, the less fades. The growth is followed along the ray, so that the estimated error is that of the ray's end.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/glm.hpp>

namespace fenestra::reference {

struct FadingPoint {
  double extinction = 0.0;  ///< κ, 1/mm
  double slope = 0.0;       ///< g
  double exponent = 0.0;    ///< p
  glm::dvec3 colour{0.0};   ///< c, lit
};

/// m at a point behind an optical depth.
inline double fadeOf(const FadingPoint& point, double depth, double sharpness) {
  return std::pow(point.slope, point.exponent * std::exp(-sharpness * depth));  // 0^0 is 1
}

/// How far a ray has come.
struct FadingState {
  glm::dvec3 colour{0.0};
  double depth = 0.0;  ///< optical
  double drift = 0.0;  ///< estimated error of `depth`
  double error = 0.0;  ///< of the worst of colour and opacity
  double transmittance() const { return std::exp(-depth); }
};

/// Greatest error of a step: `byOpacity` for each unit of opacity that it adds, and `byLength` for each mm.
struct FadingTolerance {
  double byOpacity = 0.0, byLength = 0.0;
  double leastTransmittance = 0.0;  ///< the rest of a ray behind less than that is left out
};

/// Follows a ray for `length` mm. `at(u)` is the FadingPoint at u from 0 to 1, in which nothing jumps.
template <class PointAt>
void integrateFading(FadingState& state, double sharpness, double length, const FadingTolerance& tolerance,
                     const PointAt& at) {
  constexpr std::array<double, 7> places{0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0};
  constexpr double weights[7][6] = {{},
                                    {0.2},
                                    {3.0 / 40.0, 9.0 / 40.0},
                                    {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
                                    {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
                                    {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
                                    {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0}};
  constexpr std::array<double, 7> differences{71.0 / 57600.0,      0.0,          -71.0 / 16695.0, 71.0 / 1920.0,
                                              -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0};
  constexpr double least = 1e-13;  // of the way: below that the ends of a step are the same number
  double u = 0.0, extent = 1.0;
  while (u < 1.0 && state.transmittance() >= tolerance.leastTransmittance) {
    extent = std::min(extent, 1.0 - u);
    const double h = extent * length, transmittance = state.transmittance();
    std::array<glm::dvec4, 7> slopes{};  // of colour and depth, of which the first is as seen behind `transmittance`
    double feedback = 0.0;               // the greatest ∂τ'/∂τ
    double emitted = 0.0;                // opacity of the step, summed as colours are
    for (std::size_t stage = 0; stage < places.size(); ++stage) {
      double gained = 0.0;
      for (std::size_t k = 0; k < stage; ++k) gained += h * weights[stage][k] * slopes[k].w;
      gained = std::max(gained, 0.0);
      const FadingPoint point = at(std::min(u + places[stage] * extent, 1.0));
      const double factor = fadeOf(point, state.depth + gained, sharpness), rate = point.extinction * factor;
      const double seen = std::exp(-gained) * rate;
      slopes[stage] = glm::dvec4(seen * point.colour, rate);
      if (stage < 6) emitted += h * weights[6][stage] * seen;
      if (factor > 0.0 && factor < 1.0) feedback = std::max(feedback, -sharpness * std::log(factor) * rate);
    }
    glm::dvec4 step(0.0), wrong(0.0);
    for (std::size_t stage = 0; stage < places.size(); ++stage) {
      if (stage < 6) step += h * weights[6][stage] * slopes[stage];
      wrong += h * differences[stage] * slopes[stage];
    }
    wrong = transmittance * glm::abs(wrong);
    const double opacity = -transmittance * std::expm1(-std::max(step.w, 0.0));
    // Opacity follows from the depth, so comparing with it exposes samples that miss where light is absorbed.
    const double error = std::max({wrong.x, wrong.y, wrong.z, wrong.w, std::abs(transmittance * emitted - opacity)});
    const double allowed =
        std::max(tolerance.byOpacity * opacity + tolerance.byLength * h, std::numeric_limits<double>::epsilon());
    const bool isFine = error <= allowed && step.w >= 0.0;
    if (isFine || !(extent > least)) {
      const double growth = std::exp(std::min(feedback * h, 50.0));
      state.error += error + (opacity + transmittance * feedback * h) * state.drift;
      state.drift = state.drift * growth + wrong.w / transmittance;
      state.colour += transmittance * glm::dvec3(step);
      state.depth += std::max(step.w, 0.0);
      u = extent < 1.0 - u ? u + extent : 1.0;
    }
    const double ratio = isFine || error > allowed ? error / allowed : 1e9;
    extent *= std::isfinite(ratio) ? std::clamp(0.9 * std::pow(std::max(ratio, 1e-9), -0.2), 0.1, 5.0) : 0.1;
  }
}

}  // namespace fenestra::reference
