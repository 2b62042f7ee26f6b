#pragma once
// The rules of quadrature by which the reference integrates colour.

namespace fenestra::reference {

/// Kronrod's extension of the three-point Gauss rule, exact for polynomials up to degree 11 (Kronrod, Nodes and Weights
/// of Quadrature Formulas, 1965): places on 0..1 from the middle outwards, and the weights of both rules.
struct Node {
  double offset, kronrod, gauss;
};
inline constexpr Node rule[] = {{0.0, 0.450916538658474142345, 8.0 / 9.0},
                                {0.434243749346802558002, 0.401397414775962222905, 0.0},
                                {0.774596669241483377036, 0.268488089868333440729, 5.0 / 9.0},
                                {0.960491268708020283424, 0.104656226026467265194, 0.0}};

}  // namespace fenestra::reference
