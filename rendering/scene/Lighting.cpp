#include "rendering/scene/Lighting.h"

#include <cmath>

namespace fenestra {

glm::dvec3 lightDirection(const Camera::Axes& axes, const Shading& shading) {
  const double azimuth = glm::radians(shading.lightAzimuth), elevation = glm::radians(shading.lightElevation);
  return std::cos(elevation) * (std::sin(azimuth) * axes.right - std::cos(azimuth) * axes.forward) +
         std::sin(elevation) * axes.up;
}

}  // namespace fenestra
