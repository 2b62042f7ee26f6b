#pragma once
// Directions spread evenly over the sphere, by HEALPix (Górski et al., The Astrophysical Journal 622, 2005).

#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra::placement {

/// nside of N = 12·nside² directions; empty when N is no such number.
std::optional<int> sideOf(int count);

/// A, P, L, R, S, I, as directions towards the camera (LPS).
std::span<const glm::dvec3, 6> standardDirections();

/// All directions of a resolution in RING order, which exists for every nside ≥ 1. Unit vectors in world space (LPS),
/// from the model's centre towards the camera; the pole is the patient's superior.
std::vector<glm::dvec3> ringDirections(int nside);
/// The RING pixel that contains a direction.
int ringPixel(int nside, glm::dvec3 direction);

/// NESTED order exists for nside = 2^k only; the children of pixel p at twice the resolution are 4p … 4p+3.
glm::dvec3 nestedDirection(int nside, int pixel);
/// The NESTED pixel that contains a direction.
int nestedPixel(int nside, glm::dvec3 direction);
/// The NESTED pixels that share an edge or a corner with one: eight, or seven beside the corners of the base pixels
/// where three pixels meet (nside ≥ 2).
std::vector<int> nestedNeighbours(int nside, int pixel);

/// For each direction the index of the opposite one, where the list holds it, to 1e-8. A direction is the opposite of
/// at most one other.
std::vector<std::optional<std::size_t>> oppositesOf(const std::vector<glm::dvec3>& directions);

}  // namespace fenestra::placement
