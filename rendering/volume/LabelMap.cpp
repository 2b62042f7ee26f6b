#include "rendering/volume/LabelMap.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "rendering/volume/Threads.h"

namespace fenestra {

std::uint16_t LabelMap::value(glm::ivec3 index) const {
  return voxels.visit([&](auto scalars) { return static_cast<std::uint16_t>(scalars[grid.offset(index)]); });
}

const Label* LabelMap::find(std::uint16_t value) const {
  const auto at = std::lower_bound(labels.begin(), labels.end(), value,
                                   [](const Label& label, std::uint16_t wanted) { return label.value < wanted; });
  return at != labels.end() && at->value == value ? &*at : nullptr;
}

std::vector<bool> labelsWithVoxels(const LabelMap& map) {
  constexpr std::size_t values = 65536;
  std::vector<std::uint8_t> found(values, 0);
  std::mutex mutex;
  map.voxels.visit([&](auto voxels) {
    parallelFor(voxels.size(), 1 << 20, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint8_t> mine(values, 0);
      for (std::size_t i = begin; i < end; ++i) mine[static_cast<std::uint16_t>(voxels[i])] = 1;
      const std::scoped_lock lock(mutex);
      for (std::size_t value = 0; value < values; ++value) found[value] |= mine[value];
    });
  });
  return {found.begin(), found.end()};
}

glm::dvec3 defaultLabelColour(std::uint16_t value) {
  // The golden ratio spreads consecutive hues as far apart as a fixed sequence can.
  const double hue = std::fmod(0.11 + 0.6180339887498949 * value, 1.0) * 6.0;
  const double saturation = value % 2 ? 0.65 : 0.5, brightness = value % 3 ? 0.92 : 0.78;
  const auto channel = [&](double n) {
    const double k = std::fmod(n + hue, 6.0);
    return brightness * (1.0 - saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
  };
  return {channel(5.0), channel(3.0), channel(1.0)};
}

}  // namespace fenestra
