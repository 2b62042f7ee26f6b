#include "viewer/model/FunctionEdit.h"

#include <algorithm>
#include <limits>

namespace fenestra::viewer {
namespace {

using Nodes = std::vector<TransferFunction::Node>;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool isTrapezoid(const Nodes& nodes, std::size_t first) {
  const auto extinction = [&](std::size_t node) { return nodes[first + node].properties.extinction; };
  return first + 4 <= nodes.size() && extinction(1) == extinction(2) && extinction(0) < extinction(1) &&
         extinction(3) < extinction(2);
}

/// `by`, cut so that the nodes [begin, end) stay between their neighbours.
double fitting(const Nodes& nodes, std::size_t begin, std::size_t end, double by) {
  const double low = begin > 0 ? nodes[begin - 1].value - nodes[begin].value : -infinity;
  const double high = end < nodes.size() ? nodes[end].value - nodes[end - 1].value : infinity;
  return std::clamp(by, low, high);
}

void shift(Nodes& nodes, std::size_t begin, std::size_t end, double by) {
  const double fits = fitting(nodes, begin, end, by);
  for (std::size_t node = begin; node < end; ++node) nodes[node].value += fits;
  // Rounding of the sums must not bring nodes out of order.
  if (begin > 0) nodes[begin].value = std::max(nodes[begin].value, nodes[begin - 1].value);
  if (end < nodes.size()) nodes[end - 1].value = std::min(nodes[end - 1].value, nodes[end].value);
  for (std::size_t node = begin + 1; node < end; ++node)
    nodes[node].value = std::max(nodes[node].value, nodes[node - 1].value);
}

/// The other end of the plateau that a node ends, or the node itself.
std::size_t otherEnd(const Nodes& nodes, std::size_t node) {
  if (node >= 1 && isTrapezoid(nodes, node - 1)) return node + 1;
  if (node >= 2 && isTrapezoid(nodes, node - 2)) return node - 1;
  return node;
}

/// An opacity of 0 stays exactly 0 and one that does not change keeps its extinction to the bit.
double risen(double extinction, double by) {
  return by == 0.0 ? extinction : extinctionFromOpacity(opacityFromExtinction(extinction) + by);
}

}  // namespace

std::vector<std::size_t> trapezoidsOf(const TransferFunction& function) {
  std::vector<std::size_t> result;
  for (std::size_t first = 0; first + 4 <= function.nodes.size(); ++first)
    if (isTrapezoid(function.nodes, first)) result.push_back(first);
  return result;
}

TransferFunction moved(const TransferFunction& function, Grip grip, double valueBy, double opacityBy) {
  TransferFunction result = function;
  Nodes& nodes = result.nodes;
  const std::size_t first = grip.node;
  switch (grip.part) {
    case Grip::Part::Node: {
      const std::size_t other = otherEnd(nodes, first);
      shift(nodes, first, first + 1, valueBy);
      nodes[first].properties.extinction = risen(nodes[first].properties.extinction, opacityBy);
      nodes[other].properties.extinction = nodes[first].properties.extinction;
      break;
    }
    case Grip::Part::Plateau:
      for (const std::size_t node : {first + 1, first + 2})
        nodes[node].properties.extinction = risen(nodes[node].properties.extinction, opacityBy);
      break;
    case Grip::Part::LeftEdge:
      shift(nodes, first, first + 2, valueBy);
      break;
    case Grip::Part::RightEdge:
      shift(nodes, first + 2, first + 4, valueBy);
      break;
    case Grip::Part::Whole:
      shift(nodes, first, first + 4, valueBy);
      break;
  }
  return result;
}

WithNode withNode(const TransferFunction& function, double value, double opacity) {
  WithNode result{function, 0};
  Nodes& nodes = result.function.nodes;
  const auto after = std::upper_bound(nodes.begin(), nodes.end(), value,
                                      [](double wanted, const auto& node) { return wanted < node.value; });
  result.node = static_cast<std::size_t>(after - nodes.begin());
  nodes.insert(after, {value, {function.evaluate(value).colour, extinctionFromOpacity(opacity)}});
  return result;
}

TransferFunction withoutNode(const TransferFunction& function, std::size_t node) {
  TransferFunction result = function;
  result.nodes.erase(result.nodes.begin() + static_cast<std::ptrdiff_t>(node));
  return result;
}

WithNode withTrapezoid(const TransferFunction& function, ValueRange values, double opacity) {
  WithNode result{function, 0};
  Nodes& nodes = result.function.nodes;
  OpticalProperties left = function.evaluate(values.low), right = function.evaluate(values.high);
  const glm::dvec3 colour = function.evaluate(0.5 * (values.low + values.high)).colour;
  const double beside = opacityFromExtinction(std::max(left.extinction, right.extinction));
  const double top = extinctionFromOpacity(opacity > beside ? opacity : 0.5 * (1.0 + beside));
  // An edge that rises from opacity 0 has the plateau's colour.
  if (left.extinction == 0.0) left.colour = colour;
  if (right.extinction == 0.0) right.colour = colour;
  std::erase_if(nodes, [&](const auto& node) { return node.value > values.low && node.value < values.high; });
  const auto after = std::upper_bound(nodes.begin(), nodes.end(), values.low,
                                      [](double wanted, const auto& node) { return wanted < node.value; });
  result.node = static_cast<std::size_t>(after - nodes.begin());
  const double quarter = 0.25 * (values.high - values.low);
  const TransferFunction::Node made[] = {{values.low, left},
                                         {values.low + quarter, {colour, top}},
                                         {values.high - quarter, {colour, top}},
                                         {values.high, right}};
  nodes.insert(after, std::begin(made), std::end(made));
  return result;
}

}  // namespace fenestra::viewer
