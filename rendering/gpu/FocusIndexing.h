#pragma once
// The index of a scene's focus, made from scratch.

#include <memory>
#include <optional>

#include "rendering/gpu/FocusIndex.h"

namespace fenestra {

/// The indicator of a label focus whose surface the look smooths; null for others.
std::shared_ptr<const SmoothedIndicator> smoothedIndicator(const Scene& scene);

/// `bricks` are the volume's. Runs on all cores.
FocusIndex buildFocusIndex(const Scene& scene, const BrickRanges& bricks);

/// As FocusIndex::centre(), without an index; reads the whole volume. `scene` has a volume.
std::optional<glm::dvec3> focusCentre(const Scene& scene);

}  // namespace fenestra
