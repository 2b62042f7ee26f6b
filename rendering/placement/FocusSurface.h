#pragma once
// The focus's surface as points of equal area, to measure the share of it that a camera sees.

#include <vector>

#include "rendering/gpu/FocusIndex.h"
#include "rendering/scene/Scene.h"

namespace fenestra::placement {

/// Points on the 0.5 level of the focus's indicator. Each stands for the same area; neighbours in the list are near in
/// space. Deterministic.
///
/// The area in a cell is n·∫∇I dV. The integral of the indicator's gradient is the vector area of the stepped surface
/// between the voxels; its component along the normal n of the smooth surface that the steps approximate is that
/// surface's area. This holds for any lattice, and an error of n enters in second order only. The volume's border is no
/// surface where it cuts the focus, nor is a capped face; what is clipped has no points, by the middles of the cells.
struct FocusSurface {
  struct Point {
    glm::dvec3 index{0.0};   ///< continuous index position
    glm::dvec3 normal{0.0};  ///< unit, world, out of the focus
  };
  std::vector<Point> points;
  double area = 0.0;  ///< mm², of the whole surface
};

/// About `count` points (none when the focus is empty).
FocusSurface sampleSurface(const Scene& scene, const FocusIndex& index, int count);

}  // namespace fenestra::placement
