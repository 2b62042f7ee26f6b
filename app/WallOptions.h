#pragma once
// The options for the slices that walls show.

#include "app/SceneOptions.h"

namespace fenestra::app {

/// Adds --crosshair, --window and --level. `options` must outlive `command`.
void addWallOptions(CLI::App& command, SceneOptions& options);

/// Of a session, or those of the options in its place.
ShownSlices slicesOf(const SceneOptions& options, const Volume& volume);

}  // namespace fenestra::app
