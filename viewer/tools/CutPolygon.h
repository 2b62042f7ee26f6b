#pragma once
// Where a plane cuts a volume, to be drawn in the 3-D views.

#include <vector>

#include "rendering/settings/Clipping.h"
#include "rendering/volume/Grid.h"

namespace fenestra::viewer {

/// The polygon in which a plane cuts a grid's box, in order around it; world. Empty where it misses the box.
std::vector<glm::dvec3> cutPolygon(const Grid& grid, const HalfSpace& plane);

}  // namespace fenestra::viewer
