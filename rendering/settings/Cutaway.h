#pragma once
// The parameters of the adaptive cutaway, its border and its context layer.

#include <cstdint>
#include <span>
#include <string_view>

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
  /// Degrees between the axis of the opening and the line of sight, 0 ≤ axisOffset ≤ 80: a cut straight along the view
  /// looks flat (Lidal et al. 2012).
  double axisOffset = 0.0;
  double axisDirection = 0.0;  ///< degrees: to which side of the picture the axis leans, 0 right, 90 up
  bool operator==(const Cutaway&) const = default;
};

/// How the context's first surface is drawn over the focus: its edges as lines, where it bends sharply or turns away
/// from the eye (method: curvature, illumination and value at the context's hit). strength 0 switches the layer off: no
/// pass, no memory.
struct ContextLayer {
  double strength = 0.7;                ///< 0..1, scales the layer's opacity
  double curvatureWeight = 1.0;         ///< opacity per unit of curvature × derivative scale
  double silhouetteWeight = 1.0;        ///< opacity of the term (1 - |n·v|)
  double illuminationWeight = 1.0;      ///< 0..1: from the flat colour to the colour as the surface is lit
  double valueWeight = 0.0;             ///< 0..1: from `colour` to the context's own, by its transfer function's value
  double saturation = 1.0;              ///< 0..1: of the context's own colour; 0 is its luminance
  double share = 1.0;                   ///< 0..1: of the focus's projection, at most; see ContextLines.h
  glm::dvec3 colour{0.42, 0.70, 0.90};  ///< display RGB
  bool operator==(const ContextLayer&) const = default;
};

/// Ready-made looks of an opening, one for each kind of picture in the method's Figure 5.
struct OpeningLook {
  std::string_view id, name;
  ContextLayer contextLayer;
  double borderWidth = 0.0;  ///< in the cutaway's own unit
  glm::dvec3 borderColour = Cutaway{}.borderColour;

  /// Leaves the rest of the cutaway as it is.
  void applyTo(Cutaway& cutaway, ContextLayer& layer) const;
};
/// full, a new scene's; bare (A and B: the cut alone); context (C); border (D).
std::span<const OpeningLook> openingLooks();

}  // namespace fenestra
