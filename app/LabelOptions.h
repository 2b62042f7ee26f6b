#pragma once
// Labels on the command line, by value or name: how single ones are shown.

#include "app/options/Options.h"
#include "io/study/StudyRequest.h"

namespace fenestra::app {

/// Adds --hidden, --protected, --label-opacity, --label-colour and --importance-levels.
void addLabelSettings(Command command, io::LabelChanges& changes);
/// Adds --focus-transfer.
void addFocusTransfer(Command command, io::LabelChanges& changes);

}  // namespace fenestra::app
