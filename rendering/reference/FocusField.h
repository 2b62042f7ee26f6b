#pragma once
// Where the focus is: a trilinear field, and the closed interval of its values that is focus.

#include <optional>

#include "rendering/reference/Cells.h"
#include "rendering/reference/FocusCells.h"

namespace fenestra::reference {

/// Of labels the 0/1 indicator, focus from 0.5 on; of values the volume itself, in the cells that are kept. Empty where
/// the scene has neither.
class FocusField {
 public:
  explicit FocusField(const Scene& scene);

  const ValueRange& range() const { return range_; }
  /// The field's corner values in `cell`, `values` being the volume's; nothing where the cell holds none of the focus.
  std::optional<Corners> corners(glm::ivec3 cell, const Corners& values) const;

  /// Labels: whether a voxel (clamped to the grid) carries one of the focus's.
  bool isLabelled(glm::ivec3 index) const;
  bool hasLabels() const { return !indicator_.empty(); }

 private:
  Grid grid_;
  ValueRange range_;
  std::vector<std::uint8_t> indicator_;  ///< per voxel; of labels alone
  std::optional<FocusCells> cells_;      ///< of values alone
};

}  // namespace fenestra::reference
