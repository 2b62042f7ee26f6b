#pragma once
// Exact Euclidean distances to a set of lattice points.

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "rendering/volume/Grid.h"

namespace fenestra {

/// Points at first + step · (i, j, k), counted in the points of another lattice.
struct SampledLattice {
  glm::ivec3 first{0}, step{1}, points{0};
  std::size_t count() const {
    return static_cast<std::size_t>(points.x) * static_cast<std::size_t>(points.y) * static_cast<std::size_t>(points.z);
  }
};

/// mm from each point of `at`, x fastest, to the nearest point of a set; infinite where that is empty or farther away
/// than `reach`, which spares most of the work where that is small. `set` tells for
/// each point of `grid`, x fastest, whether it belongs to the set: 0 not. `at` counts in the indices of `grid`. Exact
/// but for the rounding of float32: where the axes are orthogonal by the lower envelopes of parabolas, axis by axis (P.
/// F. Felzenszwalb, D. P. Huttenlocher: Distance transforms of sampled functions, Theory of Computing 8, 2012); in a
/// sheared grid by a search for each point, which takes some microseconds. Runs on all cores.
std::vector<float> distancesTo(std::span<const std::uint8_t> set, const Grid& grid, const SampledLattice& at,
                               double reach = std::numeric_limits<double>::infinity());

/// Whether the grid's axes are at right angles, up to the rounding of an orientation in a file.
bool isOrthogonal(const Grid& grid);

}  // namespace fenestra
