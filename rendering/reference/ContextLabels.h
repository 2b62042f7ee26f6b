#pragma once
// The translucent label of the context at a point: that of the nearest voxel (rendering/scene/FaintLabels.h).

#include <algorithm>

#include "rendering/reference/Cells.h"
#include "rendering/scene/FaintLabels.h"

namespace fenestra::reference {

class ContextLabels {
 public:
  explicit ContextLabels(const Scene& scene)
      : labels_(structuresOf(scene).get()),
        faint_(faintLabels(scene)),
        numberOfLabel_(faint_.numberOfLabel()),
        function_(scene.look.context.shifted()) {}

  /// The context's function, whatever the label.
  const TransferFunction& function() const { return function_; }
  bool any() const { return faint_.any(); }
  double opacityOf(std::size_t number) const { return faint_.opacityOf(number); }
  /// By number, the values of which 1 mm, at the label's opacity, has an opacity up to 1/255. What lies in the gaps of
  /// the first lies in those of each.
  std::vector<std::vector<ValueGap>> gaps() const {
    std::vector<std::vector<ValueGap>> all;
    for (std::size_t number = 0; number <= faint_.opacities.size(); ++number)
      all.push_back(function_.transparentGaps(std::min(1.0 / 255.0 / opacityOf(number), 1.0)));
    return all;
  }
  /// The number of the label at an index position; 0 for none.
  std::size_t numberAt(glm::dvec3 index) const {
    if (!any()) return 0;
    return numberOfLabel_[labelAt(glm::ivec3(glm::floor(index + 0.5)))];
  }
  /// Where some labels are drawn alone, ascending: that of the nearest voxel, or where that is none of them, of the
  /// first of its neighbours that is (x fastest, from the lowest index).
  std::size_t numberAt(glm::dvec3 index, const std::vector<std::uint16_t>& alone) const {
    if (!any()) return 0;
    const glm::ivec3 nearest(glm::floor(index + 0.5));
    const auto isOne = [&](std::uint16_t label) { return std::binary_search(alone.begin(), alone.end(), label); };
    std::uint16_t label = labelAt(nearest);
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
          if (const glm::ivec3 beside = nearest + glm::ivec3(x, y, z); !isOne(label) && labels_->grid.contains(beside))
            label = labels_->value(beside);
    return isOne(label) ? numberOfLabel_[label] : 0;
  }

 private:
  std::uint16_t labelAt(glm::ivec3 voxel) const {
    return labels_->value(glm::clamp(voxel, glm::ivec3(0), labels_->grid.dims - 1));
  }

  const LabelMap* labels_;
  FaintLabels faint_;
  std::vector<std::uint8_t> numberOfLabel_;
  TransferFunction function_;
};

/// Appends where along a piece the nearest voxel changes: half way between voxel centres; 0..1.
inline void appendMiddles(const Piece& piece, std::vector<double>& places) {
  for (int axis = 0; axis < 3; ++axis) {
    const double s = (0.5 - piece.begin[axis]) / (piece.end[axis] - piece.begin[axis]);
    if (s > 0.0 && s < 1.0) places.push_back(s);
  }
}

}  // namespace fenestra::reference
