#pragma once
// The options that describe what to show, common to the window and the command line. They fill the request that
// io::readStudy takes.

#include <functional>
#include <optional>

#include "app/options/Options.h"
#include "io/study/StudyRequest.h"

namespace fenestra::app {

/// Adds the options of addVolumeOptions and everything else in StudyRequest. When PATH is a session, it is read first,
/// which may throw io::Error, and the session gives the defaults of all other options; `onSession` may set the caller's
/// own options, added later, in the same way. `request` must outlive `command`.
void addSceneOptions(Command command, io::StudyRequest& request,
                     std::function<void(const io::Session&)> onSession = {});

/// Adds those of addVolumeOptions and the labels and focus in StudyRequest alone, with a session as above. `pixel`: see
/// addVolumeOptions.
void addFocusOptions(Command command, io::StudyRequest& request, std::optional<double>* pixel = nullptr);

}  // namespace fenestra::app
