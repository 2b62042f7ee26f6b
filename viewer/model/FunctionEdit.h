#pragma once
// How an editor changes a transfer function: single nodes, and trapezoids whose four nodes move as one. Nodes stay in
// ascending order of value, so a move ends at the neighbouring node. Opacities are those of 1 mm.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rendering/settings/TransferFunction.h"

namespace fenestra::viewer {

/// The part of a function that is moved.
struct Grip {
  enum class Part : std::uint8_t {
    Node,       ///< value and opacity; both ends of a plateau keep the same opacity
    Plateau,    ///< the opacity of both ends
    LeftEdge,   ///< the values of the first two nodes
    RightEdge,  ///< the values of the last two nodes
    Whole,      ///< the values of all four nodes
  };
  Part part = Part::Node;
  std::size_t node = 0;  ///< for a trapezoid, its first
  bool operator==(const Grip&) const = default;
};

/// The first nodes of all trapezoids: four nodes in a row of which the middle two have one opacity, above that of the
/// outer two.
std::vector<std::size_t> trapezoidsOf(const TransferFunction& function);

/// `function` with a part of it moved by a difference of values and of opacities, as far as the neighbours and the
/// range of opacities allow.
TransferFunction moved(const TransferFunction& function, Grip grip, double valueBy, double opacityBy);

/// The function with another node, in the colour that it had there.
struct WithNode {
  TransferFunction function;
  std::size_t node;  ///< the new one's place
};
WithNode withNode(const TransferFunction& function, double value, double opacity);
TransferFunction withoutNode(const TransferFunction& function, std::size_t node);
/// The function with a trapezoid in place of the nodes strictly between two values. Its plateau spans the middle half
/// and is at least as opaque as asked; where it would not stand out, it rises half way to full opacity. The outer nodes
/// keep the function's opacity there.
WithNode withTrapezoid(const TransferFunction& function, ValueRange values, double opacity);

}  // namespace fenestra::viewer
