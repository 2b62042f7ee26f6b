#pragma once
// Parts of a cell along a ray over which optical properties follow one line of a transfer function.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "rendering/reference/Cells.h"
#include "rendering/settings/TransferFunction.h"

namespace fenestra::reference {

/// Optical properties along a part of a cell in which they follow one line of a transfer function, or are one material
/// of the focus: κ = κ0 + x·dκ and c = c0 + x·dc, x(u) a cubic of u from 0 to 1 over the part.
struct Part {
  double begin = 0.0, end = 1.0;  ///< of the cell's piece of the ray, 0..1
  double length = 0.0;            ///< mm
  OpticalProperties from;
  double extinctionSlope = 0.0;
  glm::dvec3 colourSlope{0.0};
  Cubic x{};

  double extinction(double u) const { return std::max(0.0, from.extinction + extinctionSlope * evaluate(x, u)); }
  glm::dvec3 colour(double u) const { return from.colour + colourSlope * evaluate(x, u); }
  /// Optical depth from the part's beginning.
  double depth(double u) const {
    const double integral = u * (x[0] + u * (x[1] / 2.0 + u * (x[2] / 3.0 + u * x[3] / 4.0)));
    return std::max(0.0, length * (from.extinction * u + extinctionSlope * integral));
  }
  /// The first or second half as a part with its own u from 0 to 1, so that no depth is a difference of large ones.
  Part half(bool second) const {
    Part part = *this;
    (second ? part.begin : part.end) = 0.5 * (begin + end);
    part.length = 0.5 * length;
    // x(u/2), or x((u + 1)/2) by the Taylor series at u = 1/2.
    if (second) part.x = {evaluate(x, 0.5), x[1] + x[2] + 0.75 * x[3], x[2] + 1.5 * x[3], x[3]};
    for (std::size_t k = 1; k < 4; ++k) part.x[k] *= std::ldexp(1.0, -static_cast<int>(k));
    return part;
  }
};

/// A transfer function along part of a cell in which `value` (from 0 to 1 over the part) stays between two nodes.
inline Part functionPart(const TransferFunction& transfer, const Cubic& value, double begin, double end) {
  Part part;
  const auto at = [&](double u) { return evaluate(value, begin + (end - begin) * u); };
  const auto after = std::upper_bound(transfer.nodes.begin(), transfer.nodes.end(), at(0.5),
                                      [](double wanted, const auto& node) { return wanted < node.value; });
  if (transfer.nodes.empty()) return part;
  if (after == transfer.nodes.begin() || after == transfer.nodes.end()) {
    part.from = (after == transfer.nodes.end() ? *std::prev(after) : *after).properties;
    return part;
  }
  const TransferFunction::Node &low = *std::prev(after), &high = *after;
  part.from = low.properties;
  part.extinctionSlope = high.properties.extinction - low.properties.extinction;
  part.colourSlope = high.properties.colour - low.properties.colour;
  // Clamped: beside a value of 1e30 rounding carries a cubic far outside its nodes.
  const auto share = [&](double u) { return std::clamp((at(u) - low.value) / (high.value - low.value), 0.0, 1.0); };
  part.x = through(share(0.0), share(1.0 / 3.0), share(2.0 / 3.0), share(1.0));
  return part;
}

}  // namespace fenestra::reference
