#pragma once
// A box of voxels, and walks over it.

#include <cstddef>

#include <glm/glm.hpp>

namespace fenestra::segmentation {

/// Voxels with low ≤ index < high on each axis.
struct VoxelBox {
  glm::ivec3 low{0}, high{0};

  glm::ivec3 dims() const { return high - low; }
  bool empty() const { return high.x <= low.x || high.y <= low.y || high.z <= low.z; }
  std::size_t count() const {
    return empty() ? 0
                   : static_cast<std::size_t>(dims().x) * static_cast<std::size_t>(dims().y) *
                         static_cast<std::size_t>(dims().z);
  }
  bool contains(glm::ivec3 index) const {
    return glm::all(glm::greaterThanEqual(index, low)) && glm::all(glm::lessThan(index, high));
  }
  /// Position of a voxel in an array that holds the box alone, x fastest.
  std::size_t offset(glm::ivec3 index) const {
    const glm::ivec3 at = index - low;
    return static_cast<std::size_t>(at.x) +
           static_cast<std::size_t>(dims().x) *
               (static_cast<std::size_t>(at.y) + static_cast<std::size_t>(dims().y) * static_cast<std::size_t>(at.z));
  }
  glm::ivec3 at(std::size_t offset) const {
    const auto x = static_cast<std::size_t>(dims().x), y = static_cast<std::size_t>(dims().y);
    return low + glm::ivec3(static_cast<int>(offset % x), static_cast<int>(offset / x % y),
                            static_cast<int>(offset / (x * y)));
  }
  VoxelBox grownBy(glm::ivec3 margin) const { return {low - margin, high + margin}; }
  VoxelBox clippedTo(const VoxelBox& other) const { return {glm::max(low, other.low), glm::min(high, other.high)}; }
  bool operator==(const VoxelBox&) const = default;
};

inline VoxelBox wholeOf(glm::ivec3 dims) { return {glm::ivec3(0), dims}; }

}  // namespace fenestra::segmentation
