#pragma once
// The options for the slices that walls show.

#include "io/study/StudyRequest.h"

namespace CLI {
class App;
}

namespace fenestra::app {

/// Adds --crosshair, --window and --level. `request` must outlive `command`.
void addWallOptions(CLI::App& command, io::StudyRequest& request);

}  // namespace fenestra::app
