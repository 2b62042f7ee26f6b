#include "rendering/segmentation/Costs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace fenestra::segmentation {
namespace {

// Chosen on the marked structures of tests/bench/results/growing.md.
constexpr float brighterShare = 0.5f;  // cost of a brighter value, as a share of an equally darker one's
constexpr double noiseEdge = 4.0;      // noise deviations: edges with less are left as they are; 6 does as well
constexpr double leastEdge = 0.5;      // units of the noise: the same in volumes without noise

/// Numbers of IEEE 754 that are not negative are ordered as their bits are.
std::int32_t bitsOf(float number) { return std::bit_cast<std::int32_t>(number); }

}  // namespace

TissueCost::TissueCost(std::span<const float> tones)
    : darkest_(*std::min_element(tones.begin(), tones.end())),
      brightest_(*std::max_element(tones.begin(), tones.end())) {
  for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = segmentation::levelOf(static_cast<double>(i) / perUnit);
}

float TissueCost::operator()(float tone) const {
  return std::max(0.0f, std::max(darkest_ - tone, brighterShare * (tone - brightest_)));
}

EdgeSharpener::EdgeSharpener(const Volume& volume, const ToneScale& scale)
    : scale_(scale),
      smooth_(volume, scale),
      leastEdge_(static_cast<float>(std::max(leastEdge, noiseEdge * scale.noise().share()))) {}

void EdgeSharpener::read(const VoxelBox& box) {
  box_ = box;
  read_ = box.grownBy(glm::ivec3(1));
  tones_ = smooth_(read_);
  values_.resize(tones_.size());
  costs_.resize(tones_.size());
  std::transform(tones_.begin(), tones_.end(), values_.begin(), [&](float tone) { return scale_.linear(tone); });
  row_.resize(static_cast<std::size_t>(box.dims().x));
  levels_.resize(row_.size());
}

void EdgeSharpener::sharpenRow(int y, int z) {
  const std::size_t at = read_.offset({box_.low.x, y, z});
  const auto width = static_cast<std::ptrdiff_t>(read_.dims().x);
  const std::ptrdiff_t slice = width * static_cast<std::ptrdiff_t>(read_.dims().y);
  const float *cost = costs_.data() + at, *value = values_.data() + at;
  // A neighbour at a time for some voxels, compared as bits: such a loop runs on the processor's vectors.
  constexpr std::size_t some = 32;
  std::array<std::int32_t, some> low, high, lowValue, highValue, sharp;
  const std::int32_t edge = bitsOf(leastEdge_);
  for (std::size_t begin = 0; begin < row_.size(); begin += some, cost += some, value += some) {
    const std::size_t count = std::min(some, row_.size() - begin);
    for (std::size_t x = 0; x < count; ++x) {
      low[x] = high[x] = bitsOf(cost[x]);
      lowValue[x] = highValue[x] = bitsOf(value[x]);
    }
    for (const std::ptrdiff_t step : {std::ptrdiff_t{-1}, std::ptrdiff_t{1}, -width, width, -slice, slice}) {
      const float *const other = cost + step, *const otherValue = value + step;
      for (std::size_t x = 0; x < count; ++x) {
        const std::int32_t next = bitsOf(other[x]), nextValue = bitsOf(otherValue[x]);
        const std::int32_t least = low[x], leastValue = lowValue[x], most = high[x], mostValue = highValue[x];
        lowValue[x] = next < least ? nextValue : leastValue;
        low[x] = next < least ? next : least;
        highValue[x] = next > most ? nextValue : mostValue;
        high[x] = next > most ? next : most;
      }
    }
    for (std::size_t x = 0; x < count; ++x) {
      const float least = std::bit_cast<float>(lowValue[x]), greatest = std::bit_cast<float>(highValue[x]);
      const std::int32_t down = bitsOf(std::abs(value[x] - least)), up = bitsOf(std::abs(greatest - value[x]));
      const std::int32_t lowest = low[x], highest = high[x], own = bitsOf(cost[x]);
      const std::int32_t nearest = down <= up ? lowest : highest;
      sharp[x] = bitsOf(std::abs(greatest - least)) < edge ? own : nearest;
    }
    std::transform(sharp.begin(), sharp.begin() + static_cast<std::ptrdiff_t>(count),
                   row_.begin() + static_cast<std::ptrdiff_t>(begin),
                   [](std::int32_t bits) { return std::bit_cast<float>(bits); });
  }
}

}  // namespace fenestra::segmentation
