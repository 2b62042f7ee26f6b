#pragma once
// Reads back what the stages of a chain's last picture have made.

#include "rendering/Chain.h"
#include "rendering/Layers.h"

namespace fenestra {

/// Every stage. The context is current. Needs a picture.
Layers readLayersOf(const Chain& chain);
/// Where the rays of the camera that cuts the opening meet context and focus and where they start: tContext, tFocus and
/// tStart, empty where nothing is opened. Needs a picture.
Layers readOpeningOf(const Chain& chain);

}  // namespace fenestra
