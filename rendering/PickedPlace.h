#pragma once
// What is picked in a picture.

#include <glm/glm.hpp>

namespace fenestra {

/// A place of the volume, world, and the unit direction there of a ray that meets it.
struct PickedPlace {
  glm::dvec3 place, ray;
};

}  // namespace fenestra
