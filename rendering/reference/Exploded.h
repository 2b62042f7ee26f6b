#pragma once
// Exploded views in double precision: the picture of rendering/scene/Explosion.h, ray by ray. It shares with
// that file where the parts are, but nothing of how the renderer orders and draws them.

#include "rendering/reference/FocusLayer.h"

namespace fenestra::reference {

/// The layer of an exploded view, where `scene` is one (explosionOf), at some places of the picture, one element each.
FocusLayer explodedLayer(const Scene& scene, const Camera& camera, glm::ivec2 size,
                         const std::vector<glm::dvec2>& places, double tolerance);

}  // namespace fenestra::reference
