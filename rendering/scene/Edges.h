#pragma once
// Whether the edges in a picture are smooth; EdgeRays.h says how.

#include "rendering/scene/View.h"
#include "rendering/settings/Look.h"

namespace fenestra {

/// Whether a view's picture has smooth edges: not while things move, in draft quality, and not with an opening that is
/// not defined between pixels (MethodStages::opensBetweenPixels), nor with walls or the greatest values of the context.
bool hasSmoothEdges(const Look& look, const View& view);

}  // namespace fenestra
