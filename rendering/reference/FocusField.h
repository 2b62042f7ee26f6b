#pragma once
// Where the focus is: a trilinear field, and the closed interval of its values that is focus.

#include <optional>

#include "rendering/reference/Cells.h"
#include "rendering/scene/FocusCells.h"

namespace fenestra::reference {

/// For labels the 0/1 indicator, in focus from 0.5 on; for values the volume itself, in the cells that are kept. Empty
/// when the scene has neither.
class FocusField {
 public:
  explicit FocusField(const Scene& scene);
  /// The same of labels.
  FocusField(const LabelMap& map, const std::vector<std::uint16_t>& labels);

  const ValueRange& range() const { return range_; }
  /// The field's values at the corners of `cell`, of which `values` are the volume's; empty where the cell holds no
  /// focus.
  std::optional<Corners> corners(glm::ivec3 cell, const Corners& values) const;

  /// For labels: whether a voxel (clamped to the grid) has a label of the focus.
  bool isLabelled(glm::ivec3 index) const;
  bool hasLabels() const { return !indicator_.empty(); }

 private:
  Grid grid_;
  ValueRange range_;
  std::vector<std::uint8_t> indicator_;  ///< per voxel; for labels only
  std::optional<FocusCells> cells_;      ///< for values only
};

}  // namespace fenestra::reference
