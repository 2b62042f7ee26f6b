#include "rendering/gpu/TransferTables.h"

#include <algorithm>
#include <limits>

namespace fenestra {

glm::vec2 TransferTables::visible() const {
  const auto at = [this](int row, int entry) { return texels[static_cast<std::size_t>(row * size + entry)]; };
  const auto shows = [&](int i) { return at(0, i).a > 0.0f || (i + 1 < size && at(1, i + 1).a > at(1, i).a); };
  constexpr float infinity = std::numeric_limits<float>::infinity();
  int first = 0, last = size;
  while (first < last && !shows(first)) ++first;
  while (last > first && !shows(last - 1)) --last;
  if (first == last) return {infinity, -infinity};
  return {first == 0 ? -infinity : static_cast<float>(first) - 1.0f,
          last == size ? infinity : static_cast<float>(last)};
}

ValueRange tableSpan(const TransferFunction& function, ValueRange otherwise) {
  ValueRange span = otherwise;
  if (!function.nodes.empty()) span = {function.nodes.front().value, function.nodes.back().value};
  const double margin = span.high > span.low ? (span.high - span.low) / (TransferTables::size - 3) : 0.5;
  return {span.low - margin, span.high + margin};
}

TransferTables makeTransferTables(const TransferFunction& function, ValueRange span) {
  constexpr int size = TransferTables::size;
  const auto emission = [](const OpticalProperties& p) { return glm::dvec4(p.colour * p.extinction, p.extinction); };
  const double perEntry = (span.high - span.low) / (size - 1);
  const auto at = [&](double value) { return emission(function.evaluate(value)); };
  TransferTables tables{span, std::vector<glm::vec4>(static_cast<std::size_t>(TransferTables::rows * size))};
  glm::dvec4 integral(0.0), hidden(0.0);
  auto node = function.nodes.begin();
  for (int i = 0; i < size; ++i) {
    const double here = span.low + perEntry * i, next = span.low + perEntry * (i + 1);
    const auto entry = static_cast<std::size_t>(i);
    tables.texels[entry] = at(here);
    tables.texels[entry + size] = integral;
    tables.texels[entry + 2 * size] = glm::vec4(glm::dvec3(hidden), static_cast<double>(node - function.nodes.begin()));
    // Between nodes emission is a quadratic function of the value, so Simpson's rule is exact. Points a hair inside
    // tell the two sides of a step.
    double low = here;
    while (low < next) {
      while (node != function.nodes.end() && node->value <= low) ++node;
      const double high = node == function.nodes.end() ? next : std::min(next, node->value);
      const double hair = 1e-9 * (high - low), entries = (high - low) / perEntry;
      const glm::dvec4 first = at(low + hair), middle = at(0.5 * (low + high)), last = at(high - hair);
      hidden += (first * integral.a + 4.0 * middle * (integral.a + 0.25 * entries * (first.a + middle.a)) +
                 last * (integral.a + 0.5 * entries * (first.a + last.a))) *
                (entries / 6.0);
      integral += (first + 4.0 * middle + last) * (entries / 6.0);
      low = high;
    }
  }
  return tables;
}

glm::vec2 tableMap(ValueRange span, const VolumeTexture& coding) {
  const double perReal = (TransferTables::size - 1) / (span.high - span.low);
  return glm::vec2(coding.slope * perReal, (coding.offset - span.low) * perReal);
}

}  // namespace fenestra
