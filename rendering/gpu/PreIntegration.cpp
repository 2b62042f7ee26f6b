#include "rendering/gpu/PreIntegration.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "rendering/gpu/TransferTables.h"
#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

/// Extinction (1/mm) up to which an end of a function shows nothing: less than a ten-thousandth of 1/255 over a metre.
constexpr double invisible = 1e-10;

constexpr int float32MantissaBits = 23, droppedBits = float32MantissaBits - PreIntegration::mantissaBits;

glm::dvec3 groundOf(const OpticalProperties& end) { return end.extinction > invisible ? end.colour : glm::dvec3(0.0); }

/// From one row to the next, taken as an even medium: its colour, and its opacity at each level.
struct Step {
  glm::dvec3 colour{0.0};
  std::array<double, PreIntegration::levels> opacity{};
};

}  // namespace

PreIntegration::PreIntegration(const TransferFunction& exact, ValueRange span, int size, double longest)
    : rows((size + spacing - 2) / spacing + 1) {
  const auto greatest = static_cast<float>(longest / spacing);
  firstLevel = (std::bit_cast<std::int32_t>(greatest) >> droppedBits) - (levels - 1);
  std::array<double, perOctave> lowest{};  // mm an entry
  for (int i = 0; i < perOctave; ++i)
    lowest[static_cast<std::size_t>(i)] =
        std::bit_cast<float>(((firstLevel + i) << droppedBits) + (1 << (droppedBits - 1)));

  const double perEntry = (span.high - span.low) / (size - 1);
  const TransferFunction function = withLoweredSteps(exact, perEntry);
  std::vector<Step> steps(static_cast<std::size_t>(rows - 1));
  std::vector<double> depths(static_cast<std::size_t>(rows), 0.0);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double from = spacing * static_cast<double>(i);
    const double to = std::min(from + spacing, static_cast<double>(size - 1));
    const glm::dvec4 sum = integrateEmission(function, span.low + perEntry * from, span.low + perEntry * to) / perEntry;
    depths[i + 1] = depths[i] + sum.a;
    if (sum.a > 0.0) steps[i].colour = glm::dvec3(sum) / sum.a;
    for (std::size_t j = 0; j < lowest.size(); ++j) steps[i].opacity[j] = -std::expm1(-lowest[j] * sum.a);
    // Twice as many mm an entry: the opacity of two such media.
    for (std::size_t j = lowest.size(); j < levels; ++j) {
      const double half = steps[i].opacity[j - lowest.size()];
      steps[i].opacity[j] = half * (2.0 - half);
    }
  }

  texels.resize(static_cast<std::size_t>(2 * rows * levels));
  const auto look = [&](const OpticalProperties& end, std::size_t begin, std::size_t count, auto rowAt, auto stepTo) {
    std::vector<glm::dvec3> seen(count, groundOf(end));
    for (std::size_t k = 0; k < depths.size(); ++k) {
      const std::size_t row = rowAt(k);
      const auto depth = static_cast<float>(depths[row % depths.size()]);
      for (std::size_t j = 0; j < count; ++j) {
        if (k > 0) seen[j] += steps[stepTo(k)].opacity[begin + j] * (steps[stepTo(k)].colour - seen[j]);
        texels[row * levels + begin + j] = glm::vec4(seen[j], depth);
      }
    }
  };
  const std::size_t last = depths.size() - 1;
  parallelFor(levels, 8, [&](std::size_t begin, std::size_t end) {
    const auto down = [&](std::size_t k) { return last - k; };
    look(function.evaluate(span.high), begin, end - begin, down, down);
    look(
        function.evaluate(span.low), begin, end - begin, [&](std::size_t k) { return depths.size() + k; },
        [](std::size_t k) { return k - 1; });
  });
}

gl::Texture PreIntegration::texture() const {
  gl::Texture result = gl::Texture::make2D(gl::Format::RGBA32F, {levels, 2 * rows});
  result.upload(std::span<const glm::vec4>(texels));
  return result;
}

}  // namespace fenestra
