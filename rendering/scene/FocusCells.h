#pragma once
// Which cells of a volume a value focus keeps, and real values without NaN and Inf.

#include <cmath>
#include <cstdint>
#include <vector>

#include "rendering/scene/Focus.h"
#include "rendering/scene/Volume.h"

namespace fenestra {

/// The volume's values as the geometric stages see them. Calls f(valueAt), where valueAt(glm::ivec3) is a real value.
template <class F>
decltype(auto) withValues(const Volume& volume, F&& f) {
  return volume.voxels.visit([&](auto scalars) -> decltype(auto) {
    return f([&volume, scalars](glm::ivec3 index) {
      const double value = volume.slope * static_cast<double>(scalars[volume.grid.offset(index)]) + volume.intercept;
      if (std::isnan(value)) return volume.range.low;
      return std::isinf(value) ? (value < 0.0 ? volume.range.low : volume.range.high) : value;
    });
  });
}

/// Cells of the lattice, one between each pair of neighbouring voxel centres per axis; an axis of one voxel has one
/// cell. The half cells between the outermost centres and the border of the box belong to the nearest cell.
struct FocusCells {
  glm::ivec3 dims{0};
  std::vector<std::uint8_t> kept;  ///< x fastest; 1 where the focus may lie

  bool contains(glm::ivec3 cell) const;
};

/// Cells whose corner values overlap `focus.values`, without 26-connected components smaller than
/// `focus.minimumComponent` (the number of cells times the voxel's volume).
FocusCells focusCells(const Volume& volume, const ValueFocus& focus);

}  // namespace fenestra
