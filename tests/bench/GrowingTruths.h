#pragma once
// Known structures that regions are grown from: of the labelled data, of labelled bodies that were made, of phantoms.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rendering/segmentation/GrowthMemory.h"
#include "rendering/segmentation/Mask.h"
#include "rendering/volume/LabelMap.h"
#include "rendering/volume/Volume.h"

namespace fenestra::bench {

inline constexpr std::size_t largeVolume = 10'000'000;  ///< voxels; a fifth of the seeds, which take long enough
inline constexpr int phantomVoxels = 200;               ///< along the longest side

/// What structures have in common that one figure is wanted of. `Air`: lungs and airway; `Spine`: vertebrae and ribs;
/// `Bone`: other bones but flat ones; `Fluid`: eye, ventricles of the brain, bladder.
enum class Kind : std::uint8_t { Organ, Air, Vessel, Spine, Bone, Fluid, Nucleus, Other };

struct Structure {
  std::string name;
  Kind kind;
  std::string image, labels;  ///< of the collection; a phantom's name and empty
  std::vector<std::uint16_t> values;
  bool tuned = false;  ///< constants were chosen on it
};
std::vector<Structure> structures();
/// Whether the name holds one of the parts; true without any.
bool namesOne(const Structure& structure, const std::vector<std::string>& parts);

struct LabelledVolume {
  std::shared_ptr<const Volume> volume;
  std::shared_ptr<const LabelMap> labels;
  segmentation::GrowthMemory memory;
};
/// Opened once; empty where the data are not there.
std::optional<LabelledVolume> dataOf(const Structure& structure);

segmentation::Mask truthOf(const Structure& structure, const LabelMap& labels);
/// Voxels whose six neighbours belong to the structure too; all voxels where fewer than twenty of those are left.
std::vector<std::size_t> innerVoxels(const segmentation::Mask& truth);
/// The 26-connected part that holds a voxel: a region hangs together, so no seed reaches another part.
segmentation::Mask partWith(std::size_t seed, const segmentation::Mask& all);
glm::dvec3 worldOf(const Grid& grid, std::size_t offset);

/// Over twice the structure, or over 15 % of the body where the structure is less; `volume` and `body` in mm³.
bool isLeak(double volume, const segmentation::Mask& truth, double body);
double diceOf(const segmentation::Mask& mask, const segmentation::Mask& truth);
/// `values` is not empty.
double median(std::vector<double> values);

}  // namespace fenestra::bench
