#pragma once
// A transfer function of the context or of the focus, as both integrals read it.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "rendering/gl/Texture.h"
#include "rendering/gpu/VolumeTexture.h"
#include "rendering/settings/TransferFunction.h"

namespace fenestra {

/// Exact integrals of emission (colour · extinction) and extinction (1/mm) from one real value to a greater one, in
/// these units times that of values.
glm::dvec4 integrateEmission(const TransferFunction& function, double low, double high);

/// Rows of `size` entries, evenly spaced over `span` (real values): emission (colour · extinction) and extinction
/// (1/mm), and their integrals from the first entry on (entries/mm).
struct TransferTables {
  std::vector<glm::vec4> properties, integrals;

  TransferTables(const TransferFunction& function, ValueRange span, int size);
  /// Entries up to and from which nothing shows.
  glm::vec2 visible() const;
};

/// A transfer function from node to node, without the tables' rounding; shaders/lib/TransferSegments.glsl reads it.
struct TransferSegments {
  /// In order: the ends and an anchor (entries); colour and extinction (1/mm) at the anchor; their slopes (an entry).
  std::vector<std::array<glm::vec4, 3>> segments;
  std::vector<std::uint32_t> ofEntry;  ///< the segment that holds each entry of the tables

  TransferSegments(const TransferFunction& function, ValueRange span, int size);
  /// Puts those of another function behind them.
  void append(const TransferSegments& other);
  /// Each segment's texels one below the other, `perRow` of them side by side.
  gl::Texture texture(int perRow) const;
};

/// The gaps of values in which 1 mm has an opacity up to each of some thresholds, in coded values clipped to float's
/// range: of each threshold as many, of which some may hold no value.
std::vector<glm::vec2> codedGaps(const TransferFunction& function, const std::vector<double>& thresholds,
                                 const VolumeTexture& coding);

/// The values that a function's tables span: its nodes, and an entry more at either end, which stands for all that lies
/// beyond: there the function is constant, though it may begin or end with a step. Without nodes, `otherwise`.
ValueRange tableSpan(const TransferFunction& function, ValueRange otherwise, int size);

}  // namespace fenestra
