#pragma once
// Sessions and the options of the command line: a session gives the options their defaults, and a loaded scene can be
// saved as a session.

#include "app/SceneOptions.h"

namespace fenestra::app {

/// Sets the options to the session's look and sampling, for other options to override. loadScene takes data and cameras
/// from the session itself.
void useAsDefaults(const io::Session& session, SceneOptions& options);

/// The session of a loaded scene. io::noteContents must add the data's contents before io::writeSession.
io::Session sessionOf(const SceneOptions& options, const LoadedScene& loaded);

}  // namespace fenestra::app
