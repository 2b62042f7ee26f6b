#pragma once
// A binary tree of merges, of tissues or of parts of bones.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rendering/segmentation/Levels.h"

namespace fenestra::segmentation {

/// Nodes are numbered from the leaves on, in the order of their merges: a parent comes after its children.
struct MergeTree {
  static constexpr std::uint32_t none = UINT32_MAX;

  std::vector<std::uint32_t> parents;  ///< by node; none: the last, or of one that merges with nothing
  std::vector<float> heights;          ///< by node: cost of its merge, not less than its children's; 0 for leaves

  /// By node: the level of the least merge that holds it and `leaf`; 0 for `leaf`, never where none does.
  std::vector<Level> joinsFrom(std::uint32_t leaf) const {
    std::vector<Level> joins(parents.size(), never);
    for (std::uint32_t node = leaf; node != none; node = parents[node]) joins[node] = levelOf(heights[node]);
    for (std::size_t node = parents.size(); node-- > 0;)
      if (joins[node] == never && parents[node] != none) joins[node] = joins[parents[node]];
    return joins;
  }

  std::size_t heldBytes() const { return parents.size() * (sizeof(std::uint32_t) + sizeof(float)); }
};

}  // namespace fenestra::segmentation
