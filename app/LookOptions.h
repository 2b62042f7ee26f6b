#pragma once
// The options that say how a volume is looked at, most of them made from the declarations of settings
// (rendering/settings/Settings.h): name, form, range, help text and default. `request` must outlive `command`.

#include "app/options/Options.h"
#include "io/study/StudyRequest.h"

namespace fenestra::app {

/// Adds --transfer-function, --look, the settings of a look, and --strokes.
void addLookOptions(Command command, io::StudyRequest& request);

/// Adds --quality and --max-error.
void addSamplingOptions(Command command, io::StudyRequest& request);

/// Adds the least size of the parts of a focus of values, mm³.
void addMinimumSize(Command command, double& target);

}  // namespace fenestra::app
