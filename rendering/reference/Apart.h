#pragma once
// Stages 1 to 4 where another camera cuts the opening; see rendering/passes/RemovedPass.h.

#include "rendering/reference/Reference.h"

namespace fenestra::reference {

/// Stages 1 to 4 of the rays through some places of a picture, one element a ray. tFocusFilled, distance and editOffset
/// are empty.
Stages stagesApart(const Scene& scene, const Camera& camera, glm::ivec2 size, const OpeningView& cut,
                   const std::vector<glm::dvec2>& places);

}  // namespace fenestra::reference
