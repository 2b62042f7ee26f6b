#pragma once
// Sessions and the options of the command line: a session is a set of defaults for the options, and what they show can
// be kept as a session.

#include "app/SceneOptions.h"

namespace fenestra::app {

/// The options become what the session says, for others to override. Which data, focus and camera is not in it:
/// loadScene takes those from the session itself.
void useAsDefaults(const io::Session& session, SceneOptions& options);

/// What `loaded` shows, ready for io::writeSession but for the data's contents (io::noteContents).
io::Session sessionOf(const SceneOptions& options, const LoadedScene& loaded);

}  // namespace fenestra::app
