#pragma once
// Where the focus is, sparsely: only the bricks that its surface crosses store their cells one by one.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "rendering/gpu/Bricks.h"
#include "rendering/scene/Scene.h"
#include "rendering/scene/SmoothedIndicator.h"

namespace fenestra {

/// Built on the CPU, uploaded by GpuScene, read by shaders/lib/focus.
struct FocusIndex {
  enum class Kind : int { None = 0, Labels = 1, Values = 2 };

  Kind kind = Kind::None;
  glm::ivec3 bricks{0};
  /// Per brick: 0 no cell is in the focus, 1 all are, n ≥ 2 slot n - 2 of `cells` tells which.
  std::vector<std::uint32_t> slots;
  /// Labels: cellsPerBrick bytes a slot, one a cell, bit i set when corner i (x fastest) has a label of the focus.
  /// Values: cellsPerBrick bits a slot, one a cell, set when FocusCells (rendering/scene) keep the cell.
  std::vector<std::uint32_t> cells;
  /// Labels whose surface the look smooths: the indicator that replaces the corners' bits. The cells that it cuts are
  /// those in `cells`. Null otherwise.
  std::shared_ptr<const SmoothedIndicator> smoothed;
  /// Box of the focus in index coordinates: labelled voxels, or the corners of kept cells. Empty when nothing is in
  /// focus.
  std::optional<IndexBox> box;

  /// Whether a cell (cell frame) may hold some of the focus.
  bool holds(glm::ivec3 cell) const;
  /// Whether any cell in a box may.
  bool holdsAny(const IndexBox& cellBox) const;
  /// By brick: 1 where some of the focus lies in it, else 0.
  std::vector<std::uint8_t> occupied() const;
  /// With `smoothed`, in place of `cells` on the device: smoothedWordsPerBrick words a slot, each the indicator at two
  /// neighbouring corners of the brick's cells in 65535ths, the first in the lower half. Of a row of corners the word x
  /// is of those at x and x + 1; rows by y, then z.
  std::vector<std::uint32_t> smoothedCells() const;
  static constexpr std::size_t smoothedWordsPerBrick = std::size_t{brickSide} * (brickSide + 1) * (brickSide + 1);
  /// World position of the box's centre; empty when nothing is in focus. `grid` is the volume's.
  std::optional<glm::dvec3> centre(const Grid& grid) const;
};

}  // namespace fenestra
