#pragma once
// The seeds of a region on the command line, and the region grown from them.

#include <string>

#include "rendering/segmentation/Mask.h"
#include "rendering/segmentation/RegionGrowing.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fenestra::cli {

/// Adds --seed, --outside and --tolerance; returns --seed. `settings` must outlive `command`.
CLI::Option* addSeedOptions(CLI::App& command, segmentation::GrowSettings& settings);

struct GrownRegion {
  segmentation::Growth growth;
  int step = 0;
  segmentation::Mask mask;  ///< not empty
};
/// Throws io::Error that names `source` when a seed lies outside the volume or no voxel joins, io::Cancelled.
GrownRegion growFromSeeds(const Volume& volume, const segmentation::GrowSettings& settings, const std::string& source);

}  // namespace fenestra::cli
