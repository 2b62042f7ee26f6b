#pragma once
// The focus's surface as points of equal area: what the share that a camera sees is measured on.

#include <vector>

#include "rendering/passes/FocusIndex.h"
#include "rendering/scene/Scene.h"

namespace fenestra::placement {

/// Points on the 0.5 level of the focus's trilinear indicator, each standing for the same area. The area of a cell is the
/// integral of the indicator's gradient over it (coarea formula), so that it does not depend on how the surface lies in
/// the lattice. Where the volume ends inside the focus there is no surface. Deterministic.
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
