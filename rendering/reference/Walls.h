#pragma once
// Slices that stand as walls (MethodStages::Walls), as rendering/scene/Walls.h defines them, in double precision: each
// ray is cut with each wall's plane, values are interpolated in the volume, and lines are found by looking at all.

#include <optional>
#include <vector>

#include "rendering/reference/Reference.h"

namespace fenestra::reference {

struct WallRay {
  Ray ray;
  /// Where on the ray walls show, tOut left out; unset: everywhere before the eye.
  std::optional<Span> shown;
};

/// The nearest wall on each ray of a picture: premultiplied RGBA, 0 where there is none. The scene has walls.
std::vector<glm::dvec4> wallColours(const Scene& scene, const Camera& camera, glm::ivec2 size,
                                    const ShownSlices& slices, const std::vector<WallRay>& rays);

}  // namespace fenestra::reference
