#pragma once
// The structure under a picked point: what a click on a slice is about.

#include <optional>
#include <string>
#include <vector>

#include "rendering/scene/Scene.h"
#include "rendering/segmentation/RegionGrowing.h"

namespace fenestra::segmentation {

struct PickedStructure {
  std::shared_ptr<const LabelMap> labels;  ///< on the volume's grid; null where there is no structure
  std::vector<std::uint16_t> values;       ///< of its voxels there, ascending
  std::optional<std::uint16_t> label;      ///< the label of the scene's label map that it is; empty: a region
  bool isGrown = false;                    ///< a region grown for this pick
  std::string problem;  ///< why there is no structure, for a user; empty where there is one or it was cancelled
};

/// The region in focus, where it holds the point; else the label at the point; else the region that grows there by the
/// automatic tolerance, within previewBox(), so that the answer comes at once. `pick` is in world mm, `scene` as it is
/// drawn (DrawnScene). There is none outside the volume, in air (below -950 HU; where values are no Hounsfield units,
/// the lowest fiftieth of their range; both as means of 3³ voxels), and where no voxel joins.
PickedStructure pickedStructure(const Scene& scene, glm::dvec3 pick, const Progress& progress = {});

}  // namespace fenestra::segmentation
