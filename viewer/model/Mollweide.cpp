#include "viewer/model/Mollweide.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace fenestra::viewer {

glm::dvec2 mapFromDirection(glm::dvec3 direction) {
  const double longitude = std::atan2(direction.x, -direction.y);
  const double wanted = glm::pi<double>() * std::clamp(direction.z, -1.0, 1.0);
  // Bisection: the derivative vanishes at the poles, where Newton's steps fail.
  double low = -glm::half_pi<double>(), high = glm::half_pi<double>();
  constexpr int bits = 52;
  for (int i = 0; i < bits; ++i) {
    const double middle = 0.5 * (low + high);
    (2.0 * middle + std::sin(2.0 * middle) < wanted ? low : high) = middle;
  }
  const double theta = 0.5 * (low + high);
  return {2.0 * longitude / glm::pi<double>() * std::cos(theta), std::sin(theta)};
}

std::optional<glm::dvec3> directionFromMap(glm::dvec2 position) {
  if (0.25 * position.x * position.x + position.y * position.y > 1.0) return std::nullopt;
  const double theta = std::asin(position.y), width = std::cos(theta);
  const double sine = (2.0 * theta + std::sin(2.0 * theta)) / glm::pi<double>();
  const double longitude = width > 0.0 ? glm::half_pi<double>() * position.x / width : 0.0;
  const double cosine = std::sqrt(std::max(0.0, 1.0 - sine * sine));
  return glm::dvec3(cosine * std::sin(longitude), -cosine * std::cos(longitude), sine);
}

}  // namespace fenestra::viewer
