#pragma once
// Levels of importance in double precision: rendering/scene/Importance.h defines them.

#include "rendering/reference/Reference.h"

namespace fenestra::reference {

/// First hits of the labels of each level of importance or more, from the lowest level up, of the rays through some
/// places, whose first hits of context and focus are `hits`; not before those of the context.
std::vector<Image> importantHits(const Scene& scene, const Camera& camera, glm::ivec2 size, const HitPoints& hits,
                                 const std::vector<glm::dvec2>& places);

/// The starts on the cones of all levels, and what rays are opened to.
struct ImportantStarts {
  Image tStart, tOpened;
};
ImportantStarts importantStarts(const HitPoints& hits, const std::vector<Image>& levels, const Camera& camera,
                                glm::ivec2 size, const MethodStages& method);
/// The hits of the highest level that each ray meets.
Image highestHits(const std::vector<Image>& levels);

}  // namespace fenestra::reference
