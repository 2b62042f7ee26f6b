#pragma once
// The greatest value of the context along rays, as rendering/passes/MaximumPass.h defines it, in double precision.

#include "rendering/reference/FocusLayer.h"

namespace fenestra::reference {

/// M of each ray, premultiplied. Values between voxels are the look's own, also of a spline.
std::vector<glm::dvec4> maximumLayer(const Scene& scene, const std::vector<CutRay>& rays,
                                     const MethodStages::Maximum& maximum);

}  // namespace fenestra::reference
