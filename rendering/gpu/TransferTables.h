#pragma once
// A transfer function as the tables by which shaders integrate it (shaders/lib/Transfer.glsl).

#include <vector>

#include <glm/glm.hpp>

#include "rendering/gpu/VolumeTexture.h"
#include "rendering/scene/TransferFunction.h"

namespace fenestra {

/// Rows of `size` entries, evenly spaced over the real values of `span`: emission (colour · extinction) and extinction
/// (1/mm); their integrals from the first entry on (entries/mm); the integral of emission times that of extinction up
/// to there, which is what a stretch of values hides of itself, and the number of nodes before the entry.
struct TransferTables {
  static constexpr int size = 16384, rows = 3;

  ValueRange span;
  std::vector<glm::vec4> texels;  ///< row by row

  const glm::vec4& first() const { return texels.front(); }  ///< material at the first entry, and below it
  const glm::vec4& last() const { return texels[size - 1]; }
  /// Entries up to and from which nothing shows.
  glm::vec2 visible() const;
};

/// The values that a function's tables span: its nodes, and an entry more at either end, which stands for all that lies
/// beyond: there the function is constant, though it may begin or end with a step. Without nodes, `otherwise`.
ValueRange tableSpan(const TransferFunction& function, ValueRange otherwise);
TransferTables makeTransferTables(const TransferFunction& function, ValueRange span);
/// Entry = coded value · x + y in tables over `span`.
glm::vec2 tableMap(ValueRange span, const VolumeTexture& coding);

}  // namespace fenestra
