#pragma once
// A transfer function integrated with the attenuation inside a segment, for pictures without a bound on the error.

#include <vector>

#include <glm/glm.hpp>

#include "rendering/gl/Texture.h"
#include "rendering/settings/TransferFunction.h"

namespace fenestra {

/// What is seen along a ray whose values change evenly by one table entry every a mm, in table entries v. K(v) is the
/// integral of the extinction κ over the entries from the first one on (entries/mm), c the colour. Looking towards
/// greater values from v on, up to the table's end and an opaque ground of the colour that the function has there:
///
///   G(v) = ∫ c κ a exp(-a (K(u) - K(v))) du  over v ≤ u ≤ end  +  exp(-a (K(end) - K(v))) ground
///
/// and likewise towards smaller values, down to the first entry. A segment from v to w then shows exactly
///
///   G(v) - exp(-a |K(w) - K(v)|) G(w)
///
/// because emission and absorption are linear in what lies behind. This holds for any ground. It is that colour so that
/// values beyond an end see the same as the end; where nothing can be seen there it is black, so that the differences
/// between equal values are exactly 0.
///
/// Texels, RGBA32F: G and K. Row v / `spacing` looks towards greater values, the row `rows` below it towards smaller
/// ones. Columns are levels of a: `perOctave` ranges of equal width for each factor of 2. A level is computed for the
/// middle of its range; levelOf() of shaders/lib/PreIntegration.glsl finds it.
struct PreIntegration {
  static constexpr int spacing = 4;  ///< entries from one row to the next
  static constexpr int mantissaBits = 1, perOctave = 1 << mantissaBits, octaves = 16, levels = perOctave * octaves;

  /// Integrates the function with lowered steps (TransferTables.h). `size`: entries of the table over `span` (real
  /// values). `longest` (mm): the longest segment of a ray; as two values of a segment are a row apart at least, it
  /// says what the greatest a is.
  PreIntegration(const TransferFunction& exact, ValueRange span, int size, double longest);

  int rows = 0;        ///< of each direction
  int firstLevel = 0;  ///< what is subtracted of a's leading bits
  std::vector<glm::vec4> texels;

  gl::Texture texture() const;
};

}  // namespace fenestra
