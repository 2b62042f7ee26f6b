#pragma once
// Which cells of a volume a value focus keeps.

#include <cstdint>
#include <vector>

#include "rendering/scene/Focus.h"
#include "rendering/scene/ShownVolume.h"

namespace fenestra {

/// Cells of the lattice, one between each pair of neighbouring voxel centres per axis; an axis of one voxel has one
/// cell. The half cells between the outermost centres and the border of the box belong to the nearest cell.
struct FocusCells {
  glm::ivec3 dims{0};
  std::vector<std::uint8_t> kept;  ///< x fastest; 1 where the focus may lie

  bool contains(glm::ivec3 cell) const;
};

/// Cells whose corner values overlap `focus.values`, without 26-connected components smaller than
/// `focus.minimumComponent` (the number of cells times the voxel's volume). Of a spline also the cells around those
/// whose own corner values do not overlap: it may reach into the range between the corners. Where air belongs to the
/// range, without the cells at whose corners something is removed: what is gone is no focus, although its value is that
/// of air.
FocusCells focusCells(const ShownVolume& shown, const ValueFocus& focus);

}  // namespace fenestra
