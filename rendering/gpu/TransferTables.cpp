#include "rendering/gpu/TransferTables.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fenestra {

namespace {
glm::dvec4 emissionAt(const TransferFunction& function, double value) {
  const OpticalProperties p = function.evaluate(value);
  return glm::dvec4(p.colour * p.extinction, p.extinction);
}
}  // namespace

glm::dvec4 integrateEmission(const TransferFunction& function, double low, double high) {
  glm::dvec4 integral(0.0);
  auto node = function.nodes.begin();
  // Between nodes emission is a quadratic function of the value, so Simpson's rule is exact. Points a hair inside tell
  // the two sides of a step.
  while (low < high) {
    while (node != function.nodes.end() && node->value <= low) ++node;
    const double end = node == function.nodes.end() ? high : std::min(high, node->value), hair = 1e-9 * (end - low);
    const glm::dvec4 first = emissionAt(function, low + hair), middle = emissionAt(function, 0.5 * (low + end)),
                     last = emissionAt(function, end - hair);
    integral += (first + 4.0 * middle + last) * ((end - low) / 6.0);
    low = end;
  }
  return integral;
}

TransferFunction withLoweredSteps(const TransferFunction& function, double perEntry) {
  TransferFunction lowered;
  for (auto node = function.nodes.begin(); node != function.nodes.end();) {
    const auto end =
        std::find_if(node, function.nodes.end(), [&](const auto& other) { return other.value > node->value; });
    const double below = node->value - loweredSteps * perEntry;
    const double value = lowered.nodes.empty() ? below : std::max(below, lowered.nodes.back().value);
    if (std::distance(node, end) > 1)
      for (; node != end; ++node) lowered.nodes.push_back({value, node->properties});
    lowered.nodes.push_back(*std::prev(end));  // from the step's own value on, the function is as it was
    node = end;
  }
  return lowered;
}

TransferTables::TransferTables(const TransferFunction& exact, ValueRange span, int size) {
  const double perEntry = (span.high - span.low) / (size - 1);
  const TransferFunction function = withLoweredSteps(exact, perEntry);
  glm::dvec4 integral(0.0);
  for (int i = 0; i < size; ++i) {
    const double here = span.low + perEntry * i, next = span.low + perEntry * (i + 1);
    properties.emplace_back(emissionAt(function, here));
    integrals.emplace_back(integral);
    integral += integrateEmission(function, here, next) / perEntry;
  }
}

glm::vec2 TransferTables::visible() const {
  const auto shows = [this](std::size_t i) {
    return properties[i].a > 0.0f || (i + 1 < integrals.size() && integrals[i + 1].a > integrals[i].a);
  };
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::size_t first = 0, last = properties.size();
  while (first < last && !shows(first)) ++first;
  while (last > first && !shows(last - 1)) --last;
  if (first == last) return {infinity, -infinity};
  // What ends in a step shows up to where that is, above where the tables hold it.
  const auto end = static_cast<float>(last) + std::ceil(static_cast<float>(loweredSteps));
  return {first == 0 ? -infinity : static_cast<float>(first) - 1.0f, last == properties.size() ? infinity : end};
}

TransferSegments::TransferSegments(const TransferFunction& function, ValueRange span, int size, double rounding) {
  constexpr float far = 1e30f;
  const double perReal = (size - 1) / (span.high - span.low);
  const auto entryOf = [&](const TransferFunction::Node& node) { return (node.value - span.low) * perReal; };
  const auto material = [](const OpticalProperties& p) { return glm::dvec4(p.colour, p.extinction); };
  float low = -far;
  const auto add = [&](float high, double anchor, glm::dvec4 there, glm::dvec4 slope) {
    if (!(high > low)) return;  // a step
    segments.push_back({glm::vec4(low, high, anchor, rounding), glm::vec4(there), glm::vec4(slope)});
    low = high;
  };
  const std::vector<TransferFunction::Node>& nodes = function.nodes;
  const auto constant = [&](float high, const OpticalProperties& there) {
    add(high, 0.0, material(there), glm::dvec4(0.0));
  };
  constant(nodes.empty() ? far : static_cast<float>(entryOf(nodes.front())),
           nodes.empty() ? OpticalProperties() : nodes.front().properties);
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double from = entryOf(nodes[i]), to = entryOf(nodes[i + 1]);
    const glm::dvec4 a = material(nodes[i].properties), b = material(nodes[i + 1].properties);
    add(static_cast<float>(to), from, a, (b - a) / (to - from));
  }
  if (!nodes.empty()) constant(far, nodes.back().properties);
  std::uint32_t segment = 0;
  for (int entry = 0; entry < size; ++entry) {
    while (segments[segment][0].y < static_cast<float>(entry)) ++segment;
    ofEntry.push_back(segment);
  }
}

void TransferSegments::append(const TransferSegments& other) {
  const auto before = static_cast<std::uint32_t>(segments.size());
  segments.insert(segments.end(), other.segments.begin(), other.segments.end());
  for (const std::uint32_t segment : other.ofEntry) ofEntry.push_back(before + segment);
}

gl::Texture TransferSegments::texture(int perRow) const {
  const auto width = static_cast<std::size_t>(perRow), rows = (segments.size() + width - 1) / width;
  std::vector<glm::vec4> texels(3 * rows * width);
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t j = 0; j < 3; ++j) texels[(3 * (i / width) + j) * width + i % width] = segments[i][j];
  gl::Texture result = gl::Texture::make2D(gl::Format::RGBA32F, {perRow, 3 * static_cast<int>(rows)});
  result.upload(std::span<const glm::vec4>(texels));
  return result;
}

std::vector<glm::vec2> codedGaps(const TransferFunction& function, const std::vector<double>& thresholds,
                                 const VolumeTexture& coding) {
  constexpr double far = 1e30;
  std::vector<std::vector<glm::vec2>> each;
  std::size_t most = 0;
  for (const double opacity : thresholds) {
    std::vector<glm::vec2>& gaps = each.emplace_back();
    for (const ValueGap& gap : function.transparentGaps(opacity)) {
      const ValueRange coded = coding.codedFromReal({gap.low, gap.high});
      gaps.emplace_back(static_cast<float>(std::clamp(coded.low, -far, far)),
                        static_cast<float>(std::clamp(coded.high, -far, far)));
    }
    most = std::max(most, gaps.size());
  }
  std::vector<glm::vec2> all;
  for (std::vector<glm::vec2>& gaps : each) {
    gaps.resize(most, glm::vec2(far, -far));
    all.insert(all.end(), gaps.begin(), gaps.end());
  }
  return all;
}

ValueRange tableSpan(const TransferFunction& function, ValueRange otherwise, int size) {
  ValueRange span = otherwise;
  if (!function.nodes.empty()) span = {function.nodes.front().value, function.nodes.back().value};
  const double beyond = spanBeyondNodes, between = size - 1 - 2.0 * beyond;  // entries
  const double margin = span.high > span.low ? (span.high - span.low) * beyond / between : 0.5;
  return {span.low - margin, span.high + margin};
}

}  // namespace fenestra
