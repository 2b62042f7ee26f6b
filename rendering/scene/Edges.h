#pragma once
// Whether the edges in a picture are smooth; EdgeRays.h says how.

#include "rendering/scene/View.h"
#include "rendering/settings/Look.h"
#include "rendering/settings/Method.h"

namespace fenestra {

/// Whether the opening that a method cuts, if any, is defined between pixels, too: that of the adaptive cutaway is.
bool opensBetweenPixels(MethodKind kind);

/// Whether a view's picture has smooth edges: not while things move, in draft quality, and not with an opening that is
/// not defined between pixels.
bool hasSmoothEdges(const Look& look, const View& view);

}  // namespace fenestra
