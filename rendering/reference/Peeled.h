#pragma once
// Volumes with a layer peeled off, in double precision and one voxel at a time; what PeeledScene is tested against. It
// shares with rendering/scene/Peel.h the definition of the body's box alone. It rolls the layer up forwards, and
// inverts that by bisection.

#include <optional>

#include "rendering/scene/Scene.h"

namespace fenestra::reference {

/// Empty where nothing is peeled.
std::optional<Scene> peeledScene(const Scene& scene);

}  // namespace fenestra::reference
