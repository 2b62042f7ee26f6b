#include "rendering/settings/Cutaway.h"

#include <array>

namespace fenestra {

void OpeningLook::applyTo(Cutaway& cutaway, ContextLayer& layer) const {
  layer = contextLayer;
  cutaway.borderWidth = borderWidth;
  cutaway.borderColour = borderColour;
}

std::span<const OpeningLook> openingLooks() {
  constexpr double wideBorder = 4.0;  // wide enough to read as a line of its own, a sixth of the usual opening
  const glm::dvec3 borderOnSkin(0.10, 0.70, 0.80);
  static const std::array<OpeningLook, 4> looks{{
      {"full", "Edges and border", {}, Cutaway{}.borderWidth},
      {"bare", "Cut alone", {.strength = 0.0}},
      {"context", "Context's edges", {.strength = 0.9, .illuminationWeight = 0.7, .valueWeight = 0.35}},
      {"border", "Border", {.strength = 0.0}, wideBorder, borderOnSkin},
  }};
  return looks;
}

}  // namespace fenestra
