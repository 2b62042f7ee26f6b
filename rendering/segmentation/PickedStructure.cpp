#include "rendering/segmentation/PickedStructure.h"

#include <algorithm>

#include "rendering/segmentation/RegionFacts.h"

namespace fenestra::segmentation {

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
