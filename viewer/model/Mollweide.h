#pragma once
// The sphere of viewpoints as a map of equal areas: anterior in the middle, the patient's left on the right as seen
// from there, superior on top.
//
// Source: Snyder, Map Projections: A Working Manual (1987), pp. 249-252: 2θ + sin 2θ = π sin φ, x = 2λ/π cos θ,
// y = sin θ (R √2 taken as 1).

#include <optional>

#include <glm/glm.hpp>

namespace fenestra::viewer {

/// Mollweide projection of a unit direction (LPS): x in -2…2 from the patient's right to left, y in -1…1 upwards.
glm::dvec2 mapFromDirection(glm::dvec3 direction);
/// Empty outside the map's ellipse.
std::optional<glm::dvec3> directionFromMap(glm::dvec2 position);

}  // namespace fenestra::viewer
