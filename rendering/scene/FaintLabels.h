#pragma once
// Labels of the context that are fainter than the transfer function makes them.

#include <cstdint>
#include <utility>
#include <vector>

#include "rendering/scene/Scene.h"

namespace fenestra {

/// Labels of structuresOf(scene) that are not in focus, neither hidden nor of opacity 0, and of an opacity below 1.
///
/// The context's transfer function at a point is that of its nearest voxel's label: the volume's function, or for a
/// label listed here that function at its opacity (see atOpacity).
struct FaintLabels {
  /// Ascending, each once. Where more than `most` differ, each is rounded to a whole multiple of 1/(most + 1).
  std::vector<double> opacities;
  /// Labels, ascending, each with a number from 1 on: the label has opacities[number - 1].
  std::vector<std::pair<std::uint16_t, std::uint8_t>> numbers;

  static constexpr std::size_t most = 127;

  bool any() const { return !numbers.empty(); }
  /// Those numbers per label value, 65536 elements; 0 for labels that are not listed.
  std::vector<std::uint8_t> numberOfLabel() const;

  bool operator==(const FaintLabels&) const = default;
};

FaintLabels faintLabels(const Scene& scene);

/// The context's functions, by those numbers: the volume's (shifted), then that function at each of the opacities.
std::vector<TransferFunction> contextFunctions(const Scene& scene, const FaintLabels& faint);

}  // namespace fenestra
