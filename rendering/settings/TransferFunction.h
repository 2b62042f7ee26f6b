#pragma once
// Colour and extinction as piecewise linear functions of the real value.

#include <limits>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "rendering/volume/Volume.h"

namespace fenestra {

/// Colour in display RGB 0..1; extinction in 1/mm, so that a picture does not depend on the step length: a path of
/// length s (mm) through extinction k has opacity 1 - exp(-k·s).
struct OpticalProperties {
  glm::dvec3 colour{1.0};
  double extinction = 0.0;
  bool operator==(const OpticalProperties&) const = default;
};

/// Opacity of 1 mm of material, the unit in which transfer functions are edited and stored on disk.
double extinctionFromOpacity(double opacityPerMm);
double opacityFromExtinction(double extinction);

/// An open interval of values, either end may be infinite.
struct ValueGap {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool operator==(const ValueGap&) const = default;
};

/// Piecewise linear between nodes sorted by value, constant outside the first and last. Two nodes of equal value make a
/// step. No nodes: fully transparent.
struct TransferFunction {
  struct Node {
    double value = 0.0;
    OpticalProperties properties;
    bool operator==(const Node&) const = default;
  };
  std::vector<Node> nodes;

  OpticalProperties evaluate(double value) const;
  /// The maximal closed intervals of values in which the extinction is exactly zero; sorted, disjoint. A step shows at
  /// its own value.
  std::vector<ValueRange> emptyRanges() const;
  /// The maximal open intervals in which the opacity of 1 mm does not exceed `opacity` (method: "context is everything
  /// whose opacity exceeds ε"); sorted, disjoint.
  std::vector<ValueGap> transparentGaps(double opacity) const;

  bool operator==(const TransferFunction&) const = default;
};

}  // namespace fenestra
