#pragma once
// Where the focus is, sparsely: only bricks that its surface crosses hold anything cell by cell.

#include <cstdint>
#include <optional>
#include <vector>

#include "rendering/gpu/Bricks.h"
#include "rendering/scene/Scene.h"

namespace fenestra {

/// Built on the CPU, uploaded by GpuScene, read by shaders/lib/FocusIndex.glsl.
struct FocusIndex {
  enum class Kind : int { None = 0, Labels = 1, Values = 2 };  ///< FOCUS_KIND in the shaders

  Kind kind = Kind::None;
  glm::ivec3 bricks{0};
  /// Per brick: 0 none of the focus, 1 all cells, n ≥ 2 slot n - 2 of `cells`.
  std::vector<std::uint32_t> slots;
  /// Labels: 512 bytes a slot, one a cell, bit i set when corner i (x fastest) has a label of the focus.
  /// Values: 512 bits a slot, one a cell, set when the cell reaches into the range and its component is kept.
  std::vector<std::uint32_t> cells;
  /// Box of the focus in index coordinates: labelled voxels, or the corners of kept cells. Empty when nothing is in
  /// focus.
  std::optional<IndexBox> box;
};

/// `ranges` are the volume's bricks (used by a value focus). Both cores.
FocusIndex buildFocusIndex(const Scene& scene, const BrickRanges& ranges);

}  // namespace fenestra
