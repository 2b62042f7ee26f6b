#pragma once
// Labels on the command line, by value or name: how single ones are shown.

#include "io/study/StudyRequest.h"

namespace CLI {
class App;
}

namespace fenestra::app {

/// Adds --hidden, --protected, --label-opacity, --label-colour and --importance-levels.
void addLabelSettings(CLI::App& command, io::LabelChanges& changes);
/// Adds --focus-transfer.
void addFocusTransfer(CLI::App& command, io::LabelChanges& changes);

}  // namespace fenestra::app
