#pragma once
// The seeds and balls of a region on the command line. `region` must outlive `command`.

#include <string>

#include "app/options/Options.h"
#include "rendering/settings/Focus.h"

namespace fenestra::app {

/// Adds --seed, --outside and --tolerance; returns --seed.
Option addSeedOptions(Command command, RegionFocus& region);

/// The word that --by takes for a rule.
std::string wordOfRule(RegionRule rule);

/// Adds --select, balls that a region is painted by.
Option addSelectOption(Command command, RegionFocus& region);

}  // namespace fenestra::app
