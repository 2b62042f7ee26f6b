#pragma once
// The parameters of the adaptive cutaway, its border and its context layer.

#include <cstdint>

#include <glm/glm.hpp>

namespace fenestra {

/// Pixel: device-independent pixels, as in the paper. Millimetre: mm at the depth of the focus's centre, which keeps
/// the cut still while zooming.
enum class WidthUnit : std::uint8_t { Pixel, Millimetre };

struct Cutaway {
  bool enabled = true;
  double openWidth = 24.0;   ///< w_open, ≥ 0
  double borderWidth = 2.0;  ///< w_border, ≥ 0
  WidthUnit unit = WidthUnit::Pixel;
  glm::dvec3 borderColour{0.95, 0.85, 0.55};  ///< display RGB 0..1
  bool operator==(const Cutaway&) const = default;
};

/// How the context's edges are drawn over the focus. strength 0 switches the layer off: no pass, no memory.
struct ContextLayer {
  double strength = 0.7;                ///< 0..1, scales the layer's opacity
  double curvatureWeight = 1.0;         ///< opacity per unit of curvature × derivative scale
  double silhouetteWeight = 1.0;        ///< opacity of the term (1 - |n·v|)
  glm::dvec3 colour{0.42, 0.70, 0.90};  ///< display RGB, modulated by the illumination
  bool operator==(const ContextLayer&) const = default;
};

}  // namespace fenestra
