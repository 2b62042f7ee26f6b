#include "rendering/reference/FocusField.h"

#include "rendering/volume/Threads.h"

namespace fenestra::reference {

FocusField::FocusField(const Scene& scene) : grid_(scene.volume->grid) {
  if (const auto* focus = std::get_if<LabelFocus>(&scene.look.focus); focus && scene.labels) {
    *this = FocusField(*scene.labels, focus->labels, scene.look.labelSmoothing);
  } else if (const auto* values = std::get_if<ValueFocus>(&scene.look.focus)) {
    range_ = values->values;
    cells_ = focusCells(shownVolume(scene), *values);
  }
}

FocusField::FocusField(const LabelMap& map, const std::vector<std::uint16_t>& labels, LabelSmoothing smoothing)
    : grid_(map.grid), range_{0.5, std::numeric_limits<double>::infinity()} {
  std::vector<std::uint8_t> isFocus(std::numeric_limits<std::uint16_t>::max() + 1, 0);
  for (const std::uint16_t label : labels) isFocus[label] = 1;
  indicator_.resize(grid_.voxelCount());
  map.voxels.visit([&](auto values) {
    parallelFor(indicator_.size(), 1 << 20, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) indicator_[i] = isFocus[static_cast<std::uint16_t>(values[i])];
    });
  });
  if (smoothing != LabelSmoothing::Off) smoothed_.emplace(map, labels, smoothing);
}

Corners FocusField::indicatorAt(glm::ivec3 cell) const {
  return cornersOf(cell, grid_.dims, [&](glm::ivec3 index) { return indicatorAtVoxel(index); });
}

bool FocusField::mayHold(glm::ivec3 cell) const {
  if (cells_) return cells_->contains(cell);
  if (!hasLabels()) return false;
  const Corners corners = indicatorAt(cell);
  return std::any_of(corners.begin(), corners.end(), [this](double corner) { return corner >= range_.low; });
}

std::optional<Cubic> FocusField::along(const Piece& piece, const Cubic& value) const {
  if (!mayHold(piece.cell)) return {};
  return cells_ ? value : alongPiece(indicatorAt(piece.cell), piece);
}

double FocusField::indicatorAtVoxel(glm::ivec3 index) const {
  if (!smoothed_) return isLabelled(index) ? 1.0 : 0.0;
  return smoothed_->at(index) / double{SmoothedIndicator::one};
}

bool FocusField::isLabelled(glm::ivec3 index) const {
  return indicator_[grid_.offset(glm::clamp(index, glm::ivec3(0), grid_.dims - 1))] != 0;
}

}  // namespace fenestra::reference
