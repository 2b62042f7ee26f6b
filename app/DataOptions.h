#pragma once
// The options that say which data to open. `request` must outlive `command`.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/options/Options.h"
#include "io/study/StudyRequest.h"

namespace fenestra::app {

/// Adds PATH, --phantom, --series, --raw, --spacing, --regularise, --modality and --data. `onSession` runs as soon as
/// PATH is known to name a session, before any other option is read. With `pixel`, --spacing with one number is about
/// the picture that the command makes.
void addVolumeOptions(
    Command command, io::DataRequest& request, std::function<void()> onSession = [] {},
    std::optional<double>* pixel = nullptr);

/// Adds --labels, --label-table, and --focus-labels, which is returned and whose labels, by value or name, go to
/// `chosen`.
Option addLabelChoice(Command command, io::DataRequest& request, std::vector<std::string>& chosen);

}  // namespace fenestra::app
