#pragma once
// What the points of a focus are shown as.

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "rendering/scene/Scene.h"

namespace fenestra::reference {

/// What a point of the focus shows: one material, or a function of the value there. Where it is translucent, its bodies
/// are its label's own.
struct FocusShow {
  OpticalProperties material;
  std::optional<TransferFunction> function;
  double opacity = 1.0;
  std::uint16_t label = 0;  ///< where it is translucent
  bool operator==(const FocusShow&) const = default;
};

/// How a focus is shown. A point of a label focus is shown as its nearest voxel is, or where that voxel has no label of
/// the focus, as the first of its neighbours that has one (x fastest, from the lowest index).
class FocusShows {
 public:
  explicit FocusShows(const Scene& scene)
      : labels_(scene.labels.get()),
        first_{{scene.look.focusAppearance.colour, scene.look.focusAppearance.extinction}, {}, 1.0, 0} {
    const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
    if (std::holds_alternative<ValueFocus>(scene.look.focus)) first_.function = focusFunction(scene);
    if (!focus || !labels_ || focus->labels.empty()) {
      addNodes(first_);
      return;
    }
    entryOf_.resize(std::numeric_limits<std::uint16_t>::max() + 1, none);
    for (const std::uint16_t value : focus->labels) {
      entryOf_[value] = static_cast<int>(shows_.size());
      const DrawnInFocus drawn = drawnInFocus(scene, value);
      shows_.push_back({drawn.material, drawn.function, drawn.opacity, drawn.opacity < 1.0 ? value : std::uint16_t{0}});
      addNodes(shows_.back());
    }
    first_ = shows_.front();
    differ_ = std::any_of(shows_.begin(), shows_.end(), [&](const FocusShow& each) { return !(each == first_); });
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  }

  /// Whether there is more than one.
  bool differ() const { return differ_; }
  /// Values of all functions' nodes.
  const std::vector<double>& nodes() const { return nodes_; }

  const FocusShow& at(glm::dvec3 index) const {
    if (!differ_) return first_;
    const glm::ivec3 nearest(glm::floor(index + 0.5));
    int entry = entryAt(nearest);
    for (int n = 0; entry == none && n < 27; ++n) entry = entryAt(nearest + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1);
    return entry == none ? first_ : shows_[static_cast<std::size_t>(entry)];
  }

 private:
  static constexpr int none = -1;

  int entryAt(glm::ivec3 voxel) const { return labels_->grid.contains(voxel) ? entryOf_[labels_->value(voxel)] : none; }
  void addNodes(const FocusShow& show) {
    if (show.function)
      for (const TransferFunction::Node& node : show.function->nodes) nodes_.push_back(node.value);
  }

  const LabelMap* labels_;
  FocusShow first_;
  bool differ_ = false;
  std::vector<int> entryOf_;  ///< per label value
  std::vector<FocusShow> shows_;
  std::vector<double> nodes_;
};

}  // namespace fenestra::reference
