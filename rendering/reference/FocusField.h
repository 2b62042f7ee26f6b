#pragma once
// Where the focus is: a field, and the closed interval of its values that is focus.

#include <optional>

#include "rendering/reference/Cells.h"
#include "rendering/scene/FocusCells.h"
#include "rendering/scene/SmoothedIndicator.h"

namespace fenestra::reference {

/// For labels the trilinear 0/1 indicator, or where the look smooths it, a SmoothedIndicator; in focus from 0.5 on; for
/// values the volume itself, in the cells that are kept. Empty when the scene has neither.
class FocusField {
 public:
  explicit FocusField(const Scene& scene);
  /// The indicator of some labels of a map.
  FocusField(const LabelMap& map, const std::vector<std::uint16_t>& labels,
             LabelSmoothing smoothing = LabelSmoothing::Off);

  const ValueRange& range() const { return range_; }
  /// Whether `cell` may hold some of the focus.
  bool mayHold(glm::ivec3 cell) const;
  /// The field along a piece of a ray, of which `value` is the volume; empty where the cell holds no focus.
  std::optional<Cubic> along(const Piece& piece, const Cubic& value) const;

  /// For labels: whether a voxel (clamped to the grid) has a label of the focus.
  bool isLabelled(glm::ivec3 index) const;
  /// For labels: the indicator at a voxel (clamped to the grid).
  double indicatorAtVoxel(glm::ivec3 index) const;
  bool hasLabels() const { return !indicator_.empty(); }

 private:
  Corners indicatorAt(glm::ivec3 cell) const;

  Grid grid_;
  ValueRange range_;
  std::vector<std::uint8_t> indicator_;        ///< per voxel; for labels only
  std::optional<SmoothedIndicator> smoothed_;  ///< for labels whose surface is smoothed
  std::optional<FocusCells> cells_;            ///< for values only
};

}  // namespace fenestra::reference
