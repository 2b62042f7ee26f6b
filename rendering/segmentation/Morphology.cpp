#include "rendering/segmentation/Morphology.h"

#include <algorithm>
#include <cmath>

#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

/// For each row of the box: combine(row of `to`, row of `from` at each offset), where both lie in the box.
template <class Combine>
void overRows(std::span<const Level> from, glm::ivec3 dims, const std::vector<glm::ivec3>& offsets, std::span<Level> to,
              Combine combine) {
  const VoxelBox box = wholeOf(dims);
  parallelFor(static_cast<std::size_t>(dims.z), 1, [&](std::size_t begin, std::size_t end) {
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      for (int y = 0; y < dims.y; ++y) {
        Level* row = to.data() + box.offset({0, y, z});
        for (const glm::ivec3& offset : offsets) {
          const int otherY = y + offset.y, otherZ = z + offset.z;
          if (otherY < 0 || otherY >= dims.y || otherZ < 0 || otherZ >= dims.z) continue;
          const int first = std::max(0, -offset.x), last = std::min(dims.x, dims.x - offset.x);
          if (first >= last) continue;
          const Level* other = from.data() + box.offset({first + offset.x, otherY, otherZ});
          combine(row + first, other, last - first);
        }
      }
  });
}

}  // namespace

std::vector<glm::ivec3> ballOffsets(const Grid& grid, double radius) {
  const glm::dmat3 step(grid.direction[0] * grid.spacing.x, grid.direction[1] * grid.spacing.y,
                        grid.direction[2] * grid.spacing.z);
  // The ball's half extent along an index axis is the radius times the length of the inverse's row.
  const glm::dmat3 rows = glm::transpose(glm::inverse(step));
  glm::ivec3 reach;
  constexpr double slack = 1e-6;  // mm: a neighbour at the radius belongs to the ball whatever the rounding
  for (int axis = 0; axis < 3; ++axis)
    reach[axis] = static_cast<int>(std::floor((radius + slack) * glm::length(rows[axis])));
  std::vector<glm::ivec3> offsets;
  for (int z = -reach.z; z <= reach.z; ++z)
    for (int y = -reach.y; y <= reach.y; ++y)
      for (int x = -reach.x; x <= reach.x; ++x)
        if (glm::length(step * glm::dvec3(x, y, z)) <= radius + slack) offsets.emplace_back(x, y, z);
  return offsets;
}

std::vector<BallOffset> nearestFirst(const Grid& grid, double radius) {
  const glm::dmat4 world = grid.worldFromIndex();
  std::vector<BallOffset> offsets;
  for (const glm::ivec3 step : ballOffsets(grid, radius))
    offsets.push_back({step, glm::length(glm::dvec3(world * glm::dvec4(glm::dvec3(step), 0.0)))});
  std::ranges::stable_sort(offsets, {}, &BallOffset::length);
  return offsets;
}

double voxelSide(const Grid& grid) { return std::cbrt(grid.voxelVolume()); }

std::vector<Level> greatestWithin(std::span<const Level> levels, glm::ivec3 dims,
                                  const std::vector<glm::ivec3>& offsets) {
  std::vector<Level> greatest(levels.begin(), levels.end());
  overRows(levels, dims, offsets, greatest, [](Level* to, const Level* from, int count) {
    for (int x = 0; x < count; ++x) to[x] = std::max(to[x], from[x]);
  });
  return greatest;
}

void lowerToLeastWithin(std::span<const Level> levels, glm::ivec3 dims, const std::vector<glm::ivec3>& offsets,
                        std::span<Level> to) {
  overRows(levels, dims, offsets, to, [](Level* least, const Level* from, int count) {
    for (int x = 0; x < count; ++x) least[x] = std::min(least[x], from[x]);
  });
}

}  // namespace fenestra::segmentation
