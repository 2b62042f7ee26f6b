#include "rendering/segmentation/Costs.h"

#include <algorithm>
#include <cmath>

namespace fenestra::segmentation {
namespace {

// Chosen on the marked structures of tests/bench/results/growing.md.
constexpr float brighterShare = 0.5f;  // cost of a brighter value, as a share of an equally darker one's
constexpr double noiseEdge = 4.0;      // noise deviations: edges with less are left as they are; 6 does as well
constexpr double leastEdge = 0.5;      // units of the noise: the same in volumes without noise

}  // namespace

TissueCost::TissueCost(std::span<const float> tones)
    : darkest_(*std::min_element(tones.begin(), tones.end())),
      brightest_(*std::max_element(tones.begin(), tones.end())) {
  for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = segmentation::levelOf(static_cast<double>(i) / perUnit);
}

float TissueCost::operator()(float tone) const {
  return std::max(0.0f, std::max(darkest_ - tone, brighterShare * (tone - brightest_)));
}

EdgeSharpener::EdgeSharpener(const Volume& volume, const VoxelBox& box, const ToneScale& scale)
    : box_(box),
      read_(box.grownBy(glm::ivec3(1))),
      leastEdge_(static_cast<float>(std::max(leastEdge, noiseEdge * scale.noise().share()))),
      tones_(smoothedTones(volume, read_, scale)),
      values_(tones_.size()),
      costs_(tones_.size()),
      row_(static_cast<std::size_t>(box.dims().x)),
      levels_(row_.size()) {
  std::transform(tones_.begin(), tones_.end(), values_.begin(), [&](float tone) { return scale.linear(tone); });
}

void EdgeSharpener::sharpenRow(int y, int z) {
  const std::size_t at = read_.offset({box_.low.x, y, z});
  const auto width = static_cast<std::ptrdiff_t>(read_.dims().x);
  const std::ptrdiff_t slice = width * static_cast<std::ptrdiff_t>(read_.dims().y);
  const float *cost = costs_.data() + at, *value = values_.data() + at;
  const auto count = static_cast<std::ptrdiff_t>(row_.size());
  for (std::ptrdiff_t x = 0; x < count; ++x) {
    float low = cost[x], high = cost[x], lowValue = value[x], highValue = value[x];
    for (const std::ptrdiff_t step : {std::ptrdiff_t{-1}, std::ptrdiff_t{1}, -width, width, -slice, slice}) {
      const float other = cost[x + step], otherValue = value[x + step];
      lowValue = other < low ? otherValue : lowValue;
      low = other < low ? other : low;
      highValue = other > high ? otherValue : highValue;
      high = other > high ? other : high;
    }
    const float nearest = std::abs(value[x] - lowValue) <= std::abs(highValue - value[x]) ? low : high;
    row_[static_cast<std::size_t>(x)] = std::abs(highValue - lowValue) < leastEdge_ ? cost[x] : nearest;
  }
}

}  // namespace fenestra::segmentation
