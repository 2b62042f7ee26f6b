#pragma once
// How much of a voxel is removed, in double precision and one voxel at a time; what RemovedVoxels is tested against.
// Shares nothing with it but the removals themselves: every part of every removal is looked at, for every voxel.

#include <vector>

#include "rendering/settings/Removal.h"
#include "rendering/volume/Grid.h"

namespace fenestra::reference {

/// A plane through points in the sense of least squares, or where these lie on a line or in one place, the plane
/// through them that faces `towards` most (StrokePlane).
struct FittedPlane {
  glm::dvec3 centre{0.0}, normal{0.0};  ///< world; the normal is a unit vector
};
FittedPlane planeThrough(const std::vector<glm::dvec3>& points, glm::dvec3 towards);

/// mm along the plane's normal from the unbent plane to the bent one, where that normal runs through a point.
double bentHeight(const FittedPlane& plane, const std::vector<Bend>& bends, glm::dvec3 world);

/// 0..1 at a world position of a grid; 0 where the removals remove nothing.
double coverage(const Removals& removals, const Grid& grid, glm::dvec3 world);

}  // namespace fenestra::reference
