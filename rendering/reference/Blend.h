#pragma once
// How the reference's layers lie over each other.

#include <glm/glm.hpp>

namespace fenestra::reference {

/// Premultiplied `front` over `behind`.
inline glm::dvec4 over(glm::dvec4 front, glm::dvec4 behind) { return front + (1.0 - front.a) * behind; }

}  // namespace fenestra::reference
