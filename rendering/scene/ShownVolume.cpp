#include "rendering/scene/ShownVolume.h"

#include <algorithm>
#include <limits>

namespace fenestra {

ShownVoxels::ShownVoxels(const ShownVolume& shown) : shown_(shown) {
  const Volume& volume = this->volume();
  const double air = volume.isInHounsfieldUnits() ? std::max(airValue, volume.range.low) : volume.range.low;
  air_ = (air - volume.intercept) / volume.slope;
  rising_ = volume.slope > 0.0;
  if (!shown.labels) return;
  isHiddenLabel_.assign(std::numeric_limits<std::uint16_t>::max() + 1, 0);
  for (const std::uint16_t label : shown.hidden) isHiddenLabel_[label] = 1;
}

double ShownVoxels::value(glm::ivec3 index) const {
  const Volume& of = volume();
  const double stored = of.voxels.visit([&](auto scalars) {
    const auto own = scalars[of.grid.offset(index)];
    return static_cast<double>(hidesNothing() ? own : shown(own, index));
  });
  return of.slope * stored + of.intercept;
}

double ShownVoxels::sample(glm::dvec3 index) const {
  return interpolated(volume().grid, index, [&](glm::ivec3 voxel) { return value(voxel); });
}

}  // namespace fenestra
