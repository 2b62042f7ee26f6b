#pragma once
// Which cells of a volume a value focus keeps.

#include <cstdint>
#include <vector>

#include "rendering/scene/ShownVolume.h"
#include "rendering/settings/Focus.h"

namespace fenestra {

/// Cells of the lattice, one between each pair of neighbouring voxel centres per axis; an axis of one voxel has one
/// cell. The half cells between the outermost centres and the border of the box belong to the nearest cell.
struct FocusCells {
  glm::ivec3 dims{0};
  std::vector<std::uint8_t> kept;  ///< x fastest; 1 where the focus may lie

  bool contains(glm::ivec3 cell) const;
};

/// Cells whose corner values overlap `focus.values`, without 26-connected components smaller than
/// `focus.minimumComponent` (the number of cells times the voxel's volume). A spline may reach into the range
/// between the corners, so the cells around these are kept, too, although their own corner values do not overlap. Where
/// air belongs to the range, cells at whose corners something is removed are left out: removed voxels have the value of
/// air, but are no focus.
FocusCells focusCells(const ShownVolume& shown, const ValueFocus& focus);

}  // namespace fenestra
