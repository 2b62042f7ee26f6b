#pragma once
// The focus's surface as points of equal area: what the share that a camera sees is measured on.

#include <vector>

#include "rendering/gpu/FocusIndex.h"
#include "rendering/scene/Scene.h"

namespace fenestra::placement {

/// Points on the 0.5 level of the focus's indicator, each standing for the same area, neighbours beside one another in
/// the list. Deterministic.
///
/// The area in a cell is n·∫∇I dV: the integral of the indicator's gradient is the vector area of the surface between
/// the voxels, whatever steps that has, and its component along the normal n of the surface that the steps stand for is
/// that surface's area. It holds for any lattice, and an error of the normal counts in second order only. Where the
/// volume ends inside the focus there is no surface.
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
