#include "rendering/gpu/FittedScene.h"

#include <algorithm>
#include <cmath>

#include "rendering/gl/Context.h"
#include "rendering/gpu/Bricks.h"
#include "rendering/scene/Thinned.h"

namespace fenestra {
namespace {

/// A volume of fewer voxels is not worth thinning: if it has no room, nothing has.
constexpr std::size_t fewVoxels = std::size_t{64} * 64 * 64;

/// As makeVolumeTexture chooses them.
double texelBytes(const Volume& volume) {
  const bool integers = volume.voxels.type() != ScalarType::Float32 && volume.voxels.type() != ScalarType::Float64;
  const double span = (volume.range.high - volume.range.low) / std::abs(volume.slope);
  return !integers || span > 65535.5 ? 4.0 : span > 255.5 ? 2.0 : 1.0;
}

/// The axis whose voxels are to be joined next, or none when all are single.
std::optional<int> nextAxis(const Grid& grid, glm::ivec3 factor) {
  std::optional<int> next;
  for (int axis = 0; axis < 3; ++axis) {
    if (factor[axis] >= grid.dims[axis]) continue;
    if (!next || grid.spacing[axis] * factor[axis] < grid.spacing[*next] * factor[*next]) next = axis;
  }
  return next;
}

}  // namespace

DeviceLimits deviceLimits() { return {gl::maxTextureSize3D(), gl::freeTextureMemory()}; }

std::size_t deviceBytes(const Scene& scene, glm::ivec3 factor) {
  const Volume& volume = *scene.volume;
  constexpr double gradient = 4.0, derivative = 4.0 / 8.0;
  // A brick's range, its octants' and what shows of it, and up to three texels of two bytes.
  constexpr double brick = (sizeof(ValueRange) + sizeof(OctantRanges) + 7.0) / static_cast<double>(cellsPerBrick);
  const double perVoxel = texelBytes(volume) + (scene.look.shading.enabled ? gradient : 0.0) + derivative + brick;
  return static_cast<std::size_t>(perVoxel * static_cast<double>(thinned(volume.grid, factor).voxelCount()));
}

glm::ivec3 fittingFactor(const Scene& scene, const DeviceLimits& limits) {
  const Grid& grid = scene.volume->grid;
  glm::ivec3 factor = (grid.dims + limits.side - 1) / limits.side;
  while (limits.bytes && deviceBytes(scene, factor) > *limits.bytes) {
    const std::optional<int> axis = nextAxis(grid, factor);
    if (!axis || thinned(grid, factor).voxelCount() < fewVoxels) break;
    ++factor[*axis];
  }
  return factor;
}

void FittedScene::take(const Scene& scene, const DeviceLimits& limits) {
  source_ = shownVolume(scene);
  volume_ = nullptr;
  labels_ = structures_ = {};
  factor_ = fittingFactor(scene, limits);
}

bool FittedScene::coarsen() {
  const std::size_t before = thinned(source_.volume->grid, factor_).voxelCount();
  glm::ivec3 factor = factor_;
  // Half of what failed: fewer attempts, each of which takes seconds.
  while (2 * thinned(source_.volume->grid, factor).voxelCount() > before) {
    const std::optional<int> axis = nextAxis(source_.volume->grid, factor);
    if (!axis || before < fewVoxels) return false;
    ++factor[*axis];
  }
  factor_ = factor;
  volume_ = nullptr;
  labels_ = structures_ = {};
  return true;
}

Scene FittedScene::of(const Scene& scene) {
  if (factor_ == glm::ivec3(1)) return scene;
  if (!volume_) volume_ = thinned(source_, factor_);
  Scene fitted{volume_, thinnedOnce(labels_, scene.labels), scene.look};
  if (scene.structures) fitted.structures = thinnedOnce(structures_, scene.structures);
  // What is hidden is air in the thinned voxels.
  const std::vector<std::uint16_t> hidden = labelsWith(LabelRole::Hidden, scene);
  std::erase_if(fitted.look.labels,
                [&](const LabelSetting& each) { return std::binary_search(hidden.begin(), hidden.end(), each.label); });
  return fitted;
}

const std::shared_ptr<const LabelMap>& FittedScene::thinnedOnce(Labels& labels,
                                                                const std::shared_ptr<const LabelMap>& source) {
  if (source != labels.source) labels = {source, source ? thinned(*source, factor_) : nullptr};
  return labels.thinned;
}

}  // namespace fenestra
