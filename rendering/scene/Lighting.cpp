#include "rendering/scene/Lighting.h"

#include <array>
#include <cmath>

namespace fenestra {

glm::dvec3 lightDirection(const Camera::Axes& axes, const Shading& shading) {
  const double azimuth = glm::radians(shading.lightAzimuth), elevation = glm::radians(shading.lightElevation);
  return std::cos(elevation) * (std::sin(azimuth) * axes.right - std::cos(azimuth) * axes.forward) +
         std::sin(elevation) * axes.up;
}

void LightPreset::applyTo(Shading& shading) const {
  shading.enabled = true;
  shading.ambient = ambient;
  shading.diffuse = diffuse;
  shading.specular = specular;
  shading.shininess = shininess;
}

std::span<const LightPreset> lightPresets() {
  constexpr Shading own;
  // A surface that faces the light gives back 1 without its highlight, so that colours stay what they are.
  static constexpr std::array<LightPreset, 5> presets{{
      {"standard", "Standard", "A little gloss", own.ambient, own.diffuse, own.specular, own.shininess},
      {"matte", "Matte", "Without highlights, as plaster", 0.25, 0.75, 0.0, 1.0},
      {"bone", "Bone", "Soft shades and a wide sheen", 0.4, 0.6, 0.15, 8.0},
      {"wet", "Wet", "Small and strong highlights, as moist tissue in an operation", 0.2, 0.8, 0.6, 70.0},
      {"technical", "Technical", "Even light that keeps colours to be told apart", 0.6, 0.4, 0.0, 1.0},
  }};
  return presets;
}

}  // namespace fenestra
