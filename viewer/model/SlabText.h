#pragma once
// A slab in the window's words.

#include <QString>

#include "rendering/volume/Slab.h"

namespace fenestra::viewer {

/// "MIP", "MinIP", "Mean".
QString nameOf(SlabMode mode);
/// "MIP 10 mm".
QString slabText(const Slab& slab);

}  // namespace fenestra::viewer
