#pragma once
// The smoothed indicator of a label focus, whose gradients are the normals of its surface.

#include <cstdint>
#include <vector>

#include "rendering/gpu/FocusIndex.h"
#include "rendering/scene/Focus.h"
#include "rendering/scene/LabelMap.h"

namespace fenestra {

/// 0 outside the focus and 65535 inside (eight bits would show as facets in the normals), filtered twice by
/// (1 4 6 4 1)/16 along each axis: a Gaussian of σ = √2 voxels. x fastest.
struct FocusSmooth {
  glm::ivec3 origin{0};  ///< index of the first voxel
  glm::ivec3 size{0};
  std::vector<std::uint16_t> field;
};

/// Around the box of `index`, which was built from the same labels. Beyond the volume its edge is repeated. Filters
/// only near bricks that the surface crosses; runs on all cores.
FocusSmooth smoothFocus(const LabelMap& labels, const LabelFocus& focus, const FocusIndex& index);

}  // namespace fenestra
