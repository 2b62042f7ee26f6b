#pragma once
// The options for the slices that walls show.

#include "app/options/Options.h"
#include "io/study/StudyRequest.h"

namespace fenestra::app {

/// Adds --crosshair, --window and --level. `request` must outlive `command`.
void addWallOptions(Command command, io::StudyRequest& request);

}  // namespace fenestra::app
