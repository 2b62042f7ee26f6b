#pragma once
// The options that describe what to show, common to the window and the command line. They fill the request that
// io::readStudy takes.
//
// Values are checked while parsing, and mistakes throw CLI::ParseError. Numbers have a decimal point in every locale.
// A request must outlive its command.

#include <functional>

#include "io/study/StudyRequest.h"

namespace CLI {
class App;
}

namespace fenestra::app {

/// Adds PATH, --phantom, --series, --raw, --spacing, --regularise, --modality and --data.
void addVolumeOptions(CLI::App& command, io::DataRequest& request);

/// Adds the options of addVolumeOptions, --labels, and --focus-labels, whose labels go to `focusLabels`.
void addLabelOptions(CLI::App& command, io::DataRequest& request, std::vector<std::string>& focusLabels);

/// Adds the above and everything else in StudyRequest. When PATH is a session, parsing reads it first, which may throw
/// io::Error, and the session gives the defaults of all other options; `onSession` may set the caller's own options,
/// added later, in the same way.
void addSceneOptions(CLI::App& command, io::StudyRequest& request,
                     std::function<void(const io::Session&)> onSession = {});

}  // namespace fenestra::app
