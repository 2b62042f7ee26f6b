#pragma once
// The seeds and balls of a region on the command line. `region` must outlive `command`.

#include "rendering/scene/Focus.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fenestra::app {

/// Adds --seed, --outside and --tolerance; returns --seed.
CLI::Option* addSeedOptions(CLI::App& command, RegionFocus& region);

/// Adds --select, balls that a region is painted by.
CLI::Option* addSelectOption(CLI::App& command, RegionFocus& region);

}  // namespace fenestra::app
