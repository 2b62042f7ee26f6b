#include "rendering/segmentation/PickedStructure.h"

#include <algorithm>

namespace fenestra::segmentation {
namespace {

/// HU: darker lung is counted as air, too (Gevenois et al., American Journal of Respiratory and Critical Care Medicine
/// 152(2), 1995).
constexpr double airThreshold = -950.0;
/// Where values are no Hounsfield units, the lowest share of their range that counts as air.
constexpr double airShare = 0.02;

bool isAir(const Volume& volume, glm::ivec3 voxel) {
  double sum = 0.0;
  for (int i = 0; i < 27; ++i) {
    const glm::ivec3 neighbour = voxel + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
    sum += volume.value(glm::clamp(neighbour, glm::ivec3(0), volume.grid.dims - 1));
  }
  const double mean = sum / 27.0;
  if (volume.isInHounsfieldUnits()) return mean < airThreshold;
  return !(mean > volume.range.low + airShare * (volume.range.high - volume.range.low));  // NaN is air
}

}  // namespace

PickedStructure pickedStructure(const Scene& scene, glm::dvec3 pick, const Progress& progress) {
  PickedStructure picked;
  const std::optional<glm::ivec3> voxel = voxelAt(scene.volume->grid, pick);
  if (!voxel) {
    picked.problem = "the point lies outside of the volume";
    return picked;
  }
  const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
  if (focus && scene.labels && !focusesStructures(scene) &&
      std::binary_search(focus->labels.begin(), focus->labels.end(), scene.labels->value(*voxel))) {
    picked.labels = scene.labels;
    picked.values = focus->labels;
    return picked;
  }
  if (const auto& structures = structuresOf(scene); structures && structures->value(*voxel) != 0) {
    picked.labels = structures;
    picked.label = structures->value(*voxel);
    picked.values = {*picked.label};
    return picked;
  }
  if (isAir(*scene.volume, *voxel)) {
    picked.problem = "the point lies in air, where there is no structure";
    return picked;
  }
  const RegionFocus seed{{pick}, {}, {}};
  const auto growth = growRegion(*scene.volume, seed, previewBox(*scene.volume, seed), progress);
  if (!growth) return picked;
  const int step = growth->stepOf(seed);
  if (growth->curve.volume[static_cast<std::size_t>(step)] == 0.0) {
    picked.problem = "no region can be grown from the point";
    return picked;
  }
  picked.labels = growth->steps;
  picked.isGrown = true;
  for (int value = 1; value <= step; ++value) picked.values.push_back(static_cast<std::uint16_t>(value));
  return picked;
}

}  // namespace fenestra::segmentation
