#pragma once
// What the user wants to see: a set of labels, or a range of values.

#include <cstdint>
#include <variant>
#include <vector>

#include "rendering/scene/Volume.h"

namespace fenestra {

/// The union of labels; its surface is the 0.5 level of the trilinearly interpolated 0/1 indicator.
struct LabelFocus {
  std::vector<std::uint16_t> labels;  ///< sorted, unique, non-empty
  bool operator==(const LabelFocus&) const = default;
};

/// All points whose interpolated value lies in `values`, without connected components smaller than
/// `minimumComponent` mm³: a value range catches islands (a cable, a filling), and each would open a hole of its own.
/// A component is a 26-connected set of cells whose corner values overlap the range, so it is kept or dropped whole and
/// the surface stays a level set.
struct ValueFocus {
  ValueRange values;
  double minimumComponent = 300.0;
  bool operator==(const ValueFocus&) const = default;
};

/// std::monostate: no focus, a plain volume rendering.
using Focus = std::variant<std::monostate, LabelFocus, ValueFocus>;

}  // namespace fenestra
