#include "rendering/scene/Lighting.h"

namespace fenestra {

glm::dvec3 lightDirection(const Camera::Axes& axes, const Shading&) {
  return glm::normalize(-axes.forward + 0.45 * axes.up - 0.35 * axes.right);
}

}  // namespace fenestra
