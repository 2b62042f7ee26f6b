#pragma once
// Directions spread evenly over the sphere, by HEALPix (Górski et al., The Astrophysical Journal 622, 2005).

#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra::placement {

/// nside of N = 12·nside² directions; empty when N is no such number.
std::optional<int> sideOf(int count);

/// All directions of a resolution in RING order, which exists for every nside ≥ 1. Unit vectors in world space (LPS),
/// from the model's centre towards the camera; the pole is the patient's superior.
std::vector<glm::dvec3> ringDirections(int nside);

/// NESTED order exists for nside = 2^k only; the children of pixel p at twice the resolution are 4p … 4p+3.
glm::dvec3 nestedDirection(int nside, long pixel);
/// NESTED pixel that a direction lies in.
long nestedPixel(int nside, glm::dvec3 direction);

/// For each direction the index of the opposite one, where it is among them, to 1e-8: pairs, of which no two share one.
std::vector<std::optional<std::size_t>> oppositesOf(const std::vector<glm::dvec3>& directions);

/// RING pixel that a direction lies in.
long ringPixel(int nside, glm::dvec3 direction);

}  // namespace fenestra::placement
