#pragma once
// ClearView's lens in double precision, as rendering/methods/clearview/ClearView.h defines it.

#include <vector>

#include "rendering/reference/Reference.h"

namespace fenestra::reference {

/// What the lens does on one ray.
struct LensPoint {
  glm::dvec3 normal{0.0};  ///< of the context's first surface, along the view's axes; 0 where it has none
  double distance;         ///< mm from the lens's middle; NaN where no context lies before the focus
  double share;            ///< w: how much of what the opening removes shows
  double line;             ///< of the picture's opacity, which the line around the lens takes from each channel
};

/// The lens at some pixels of a picture whose first hits are `hits`. `slices` counts by its crosshair alone.
std::vector<LensPoint> lensPoints(const Scene& scene, const Camera& camera, glm::ivec2 size, const HitPoints& hits,
                                  const std::vector<glm::ivec2>& pixels, const ShownSlices& slices = {});

}  // namespace fenestra::reference
