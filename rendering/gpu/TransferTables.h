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

/// By how many entries draft and normal quality hold steps below their values, and how many entries the tables span
/// beyond the outermost nodes. These qualities round entries by up to 8: where a whole region has the very value of a
/// step, it shows what TransferFunction::evaluate() has there, the material above the step.
inline constexpr double loweredSteps = 8.25;
inline constexpr int spanBeyondNodes = 16;

/// The function with its steps that much lower, but no lower than the node before. `perEntry`: real values an entry.
TransferFunction withLoweredSteps(const TransferFunction& function, double perEntry);

/// Rows of `size` entries of the function with lowered steps, evenly spaced over `span` (real values): emission (colour
/// · extinction) and extinction (1/mm), and their integrals from the first entry on (entries/mm).
struct TransferTables {
  std::vector<glm::vec4> properties, integrals;

  TransferTables(const TransferFunction& exact, ValueRange span, int size);
  /// Entries up to and from which nothing shows, by the tables or by the function itself.
  glm::vec2 visible() const;
};

/// A transfer function from node to node, without the tables' rounding; shaders/lib/TransferSegments.glsl reads it.
struct TransferSegments {
  /// In order: the ends, an anchor, and `rounding` (entries); colour and extinction (1/mm) at the anchor; their slopes
  /// (an entry).
  std::vector<std::array<glm::vec4, 3>> segments;
  std::vector<std::uint32_t> ofEntry;  ///< the segment that holds each entry of the tables

  /// `rounding`: more than rounding moves the entries that shaders compute, in entries. Where all voxels of a region
  /// have the value of a step, it keeps rounding from deciding over the region.
  TransferSegments(const TransferFunction& function, ValueRange span, int size, double rounding);
  /// Puts those of another function behind them.
  void append(const TransferSegments& other);
  /// Each segment's texels one below the other, `perRow` of them side by side.
  gl::Texture texture(int perRow) const;
};

/// The gaps of values in which 1 mm has an opacity up to each of some thresholds, in coded values clipped to float's
/// range: of each threshold as many, of which some may hold no value.
std::vector<glm::vec2> codedGaps(const TransferFunction& function, const std::vector<double>& thresholds,
                                 const VolumeTexture& coding);

/// The values that a function's tables span: its nodes, and `spanBeyondNodes` entries at either end, where the function
/// is constant, though it may begin or end with a step. Without nodes, `otherwise`.
ValueRange tableSpan(const TransferFunction& function, ValueRange otherwise, int size);

}  // namespace fenestra
