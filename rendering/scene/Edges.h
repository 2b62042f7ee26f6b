#pragma once
// Whether the edges in a picture are smooth; EdgeRays.h says how.

#include <cstdint>

#include "rendering/scene/View.h"

namespace fenestra {

struct Look;

/// How pictures show edges.
enum class Edges : std::uint8_t { Off, Smooth };

/// Whether a view's picture has smooth edges: not while things move, in draft quality, and not with an opening of
/// another method than the adaptive cutaway, whose opening is defined between pixels.
bool hasSmoothEdges(const Look& look, const View& view);

}  // namespace fenestra
