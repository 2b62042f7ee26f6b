#include "io/results/FocusSegment.h"

#include "rendering/scene/FocusCells.h"
#include "rendering/segmentation/Mask.h"
#include "rendering/volume/Threads.h"

namespace fenestra::io {
namespace {

segmentation::Mask valueMask(const Scene& scene, const ValueFocus& focus) {
  const ShownVolume shown = shownVolume(scene);
  const FocusCells cells = focusCells(shown, focus);
  const Grid& grid = scene.volume->grid;
  segmentation::Mask mask{grid, std::vector<std::uint8_t>(grid.voxelCount(), 0)};
  const ShownVoxels voxels(shown);
  // A voxel is a corner of the cells on both its sides along each axis; contains() clamps those beyond the border.
  const auto isKept = [&](glm::ivec3 voxel) {
    for (int n = 0; n < 8; ++n)
      if (cells.contains(voxel - glm::ivec3(n % 2, n / 2 % 2, n / 4))) return true;
    return false;
  };
  withValues(shown, [&](auto valueAt) {
    parallelFor(static_cast<std::size_t>(grid.dims.z), 1, [&](std::size_t begin, std::size_t end) {
      glm::ivec3 voxel;
      for (voxel.z = static_cast<int>(begin); voxel.z < static_cast<int>(end); ++voxel.z)
        for (voxel.y = 0; voxel.y < grid.dims.y; ++voxel.y)
          for (voxel.x = 0; voxel.x < grid.dims.x; ++voxel.x) {
            const double value = valueAt(voxel);
            if (value >= focus.values.low && value <= focus.values.high && !voxels.isGone(voxel) && isKept(voxel))
              mask.voxels[grid.offset(voxel)] = 1;
          }
    });
  });
  return mask;
}

}  // namespace

std::shared_ptr<const LabelMap> focusSegment(const Scene& scene, const std::string& name) {
  const Label as{1, name, segmentation::regionColour};
  if (std::holds_alternative<LabelFocus>(scene.look.focus)) return segmentation::focusLabel(scene, as);
  if (const auto* values = std::get_if<ValueFocus>(&scene.look.focus))
    return segmentation::labelMapOf(valueMask(scene, *values), as);
  return nullptr;
}

}  // namespace fenestra::io
