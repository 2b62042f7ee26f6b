#pragma once
// How a new scene looks before anybody chooses. The initialisers of Look and its parts are another thing: the plain
// look, which costs least, and what a file means that does not name a setting.

#include "rendering/settings/Look.h"

namespace fenestra {

/// Smooth reconstruction where voxels are coarse, lightly smoothed labels, smooth edges, hollows and a soft shadow that
/// leave the focus bright, and the opening's first look. What depends on the data depends on it when a picture is drawn
/// (reconstructionOf() of Scene.h), or follows when they are read (defaultPreset() of io/TransferFunctionFile.h).
Look startingLook();

/// The style of the plain look, with the opening's bare one: nothing but the volume, the focus and the cut.
Look bareLook();

}  // namespace fenestra
