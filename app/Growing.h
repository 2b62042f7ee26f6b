#pragma once
// The seeds of a region on the command line, and the region grown from them.

#include <memory>
#include <string>

#include "io/base/Reading.h"
#include "rendering/segmentation/RegionGrowing.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fenestra::app {

/// Adds --seed, --outside and --tolerance; returns --seed. `region` must outlive `command`.
CLI::Option* addSeedOptions(CLI::App& command, RegionFocus& region);

/// Adds --select, balls that a region is painted by.
CLI::Option* addSelectOption(CLI::App& command, RegionFocus& region);

/// Throws io::Error that names `source` when a seed or ball lies outside the volume or no voxel joins, io::Cancelled.
std::shared_ptr<const segmentation::Growth> grow(const Volume& volume, const RegionFocus& region,
                                                 const std::string& source, const io::Progress& progress = {});

}  // namespace fenestra::app
