#pragma once
// The options of `place`.

#include "app/options/Options.h"
#include "io/session/Session.h"

namespace fenestra::cli {

struct PlaceOptions;

/// Adds all but those of the scene. `options` must outlive `command`.
void addPlacementOptions(app::Command command, PlaceOptions& options);

/// Sets what a session says about placement, for the options to override.
void useAsDefaults(const io::Session& session, PlaceOptions& options);

}  // namespace fenestra::cli
