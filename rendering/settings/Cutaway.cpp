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
  // Lines in the tissue's own pale colour say what was removed. They cover a tenth of the focus: an eighth less what
  // smooth edges add around them.
  const ContextLayer lines{.strength = 0.8, .valueWeight = 1.0, .saturation = 0.5, .share = 0.1};
  ContextLayer strongLines = lines;
  strongLines.strength = 0.95;
  static const std::array<OpeningLook, 4> looks{{
      {"full", "Edges and border", lines, Cutaway{}.borderWidth},
      {"bare", "Cut alone", {.strength = 0.0}},
      {"context", "Context's edges", strongLines},
      {"border", "Border", {.strength = 0.0}, wideBorder, borderOnSkin},
  }};
  return looks;
}

}  // namespace fenestra
