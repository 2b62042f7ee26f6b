#pragma once
// Labels of the context that are translucent: LabelSettings.h says what their opacity means.

#include <cstdint>
#include <utility>
#include <vector>

#include "rendering/scene/Scene.h"

namespace fenestra {

/// Labels of structuresOf(scene) that are not in focus, neither hidden nor of opacity 0, and of an opacity below 1.
///
/// A point of the context belongs to its nearest voxel's label. It is context where the opacity over 1 mm, times the
/// label's, exceeds a threshold.
struct FaintLabels {
  /// One for each label. For more labels than `most` each once, ascending: labels of one opacity are one body then; and
  /// where more than `most` differ, each is rounded to a whole multiple of 1/(most + 1).
  std::vector<double> opacities;
  /// Labels, ascending, each with a number from 1 on: the label has opacities[number - 1].
  std::vector<std::pair<std::uint16_t, std::uint8_t>> numbers;

  static constexpr std::size_t most = 127;

  bool any() const { return !numbers.empty(); }
  /// The opacity of the label of that number; 1 for 0, which is no label listed here.
  double opacityOf(std::size_t number) const { return number == 0 ? 1.0 : opacities[number - 1]; }
  /// Those numbers per label value, 65536 elements; 0 for labels that are not listed.
  std::vector<std::uint8_t> numberOfLabel() const;

  bool operator==(const FaintLabels&) const = default;
};

FaintLabels faintLabels(const Scene& scene);
/// Whether labels are drawn as bodies: some in the context are faint, or some in focus of an opacity below 1.
bool hasBodies(const Scene& scene);

/// Even media in place of the context's labels, by those numbers: the volume's function (shifted), then that function
/// at each of the opacities.
std::vector<TransferFunction> contextFunctions(const Scene& scene, const FaintLabels& faint);

}  // namespace fenestra
