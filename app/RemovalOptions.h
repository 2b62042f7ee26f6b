#pragma once
// --carve and --bend: what is removed from a volume (rendering/settings/Removal.h).

#include "app/options/Options.h"
#include "rendering/settings/Removal.h"

namespace fenestra::app {

/// Each option, where it is given, takes the place of what `removals` holds of its kind: --bend of planes, --carve of
/// all others.
void addRemovals(Command command, Removals& removals);

}  // namespace fenestra::app
