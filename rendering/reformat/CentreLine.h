#pragma once
// The centre line of a tube: a vessel, a duct, a cord.
//
// Its ends are the two voxels of the region that are farthest from each other on ways within it. Between them runs the
// way of least cost, where a step costs its length over the square of its distance to the region's surface, so that it
// keeps to the middle (the idea of the distance-weighted minimal path; L. Antiga et al.: Centerline computation and
// geometric analysis of branching tubular surfaces, IEEE Transactions on Medical Imaging 22(5), 2003, weigh the same
// distance on its Voronoi diagram). Points of that way are then moved to the middles of the region's cross-sections,
// and both ends are led on straight to the surface. Of a region with branches, that is the longest way through it.

#include <vector>

#include "rendering/reformat/Region.h"

namespace fenestra::reformat {

struct CentreLine {
  std::vector<glm::dvec3> points;  ///< LPS, mm, for a PathCurve; the end that is farther up (S) first
  double radius = 0.0;             ///< mm, the median distance of its voxels to the surface
};

/// Empty points where the region has no two voxels that are farther apart than it is thick: it is no tube. Takes some
/// seconds for a million voxels.
CentreLine centreLineOf(const VoxelRegion& region);

}  // namespace fenestra::reformat
