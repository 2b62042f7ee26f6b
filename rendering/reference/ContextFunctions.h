#pragma once
// The context's transfer function at a point: that of the nearest voxel's label (rendering/scene/FaintLabels.h).

#include "rendering/reference/Cells.h"
#include "rendering/scene/FaintLabels.h"

namespace fenestra::reference {

class ContextFunctions {
 public:
  explicit ContextFunctions(const Scene& scene)
      : labels_(structuresOf(scene).get()),
        functions_(contextFunctions(scene, faintLabels(scene))),
        numberOfLabel_(faintLabels(scene).numberOfLabel()) {}

  /// All functions, the volume's first. Their nodes have the same values, and a value that does not show in the first
  /// shows in none.
  const std::vector<TransferFunction>& all() const { return functions_; }
  bool differ() const { return functions_.size() > 1; }
  /// The number in all() of the function at an index position.
  std::size_t numberAt(glm::dvec3 index) const {
    if (!differ()) return 0;
    const glm::ivec3 nearest(glm::floor(index + 0.5));
    return numberOfLabel_[labels_->value(glm::clamp(nearest, glm::ivec3(0), labels_->grid.dims - 1))];
  }

 private:
  const LabelMap* labels_;
  std::vector<TransferFunction> functions_;
  std::vector<std::uint8_t> numberOfLabel_;
};

/// Appends where along a piece the nearest voxel changes: half way between voxel centres; 0..1.
inline void appendMiddles(const Piece& piece, std::vector<double>& places) {
  for (int axis = 0; axis < 3; ++axis) {
    const double s = (0.5 - piece.begin[axis]) / (piece.end[axis] - piece.begin[axis]);
    if (s > 0.0 && s < 1.0) places.push_back(s);
  }
}

}  // namespace fenestra::reference
