#include "rendering/passes/Bricks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rendering/scene/Parallel.h"

namespace fenestra {

void grow(std::optional<IndexBox>& box, glm::ivec3 low, glm::ivec3 high) {
  box = box ? IndexBox{glm::min(box->low, low), glm::max(box->high, high)} : IndexBox{low, high};
}

glm::ivec3 brickCount(glm::ivec3 dims) { return (dims + 1 + brickSide - 1) / brickSide; }

std::size_t brickOffset(glm::ivec3 bricks, glm::ivec3 brick) {
  return static_cast<std::size_t>(brick.x) +
         static_cast<std::size_t>(bricks.x) * (static_cast<std::size_t>(brick.y) +
                                               static_cast<std::size_t>(bricks.y) * static_cast<std::size_t>(brick.z));
}

std::size_t cellInBrick(glm::ivec3 cell) {
  const glm::ivec3 local = cell % brickSide;
  return static_cast<std::size_t>(local.x + brickSide * (local.y + brickSide * local.z));
}

BrickRanges brickRanges(const Volume& volume) {
  const glm::ivec3 dims = volume.grid.dims;
  BrickRanges result;
  result.dims = brickCount(dims);
  result.ranges.resize(static_cast<std::size_t>(result.dims.x) * static_cast<std::size_t>(result.dims.y) *
                       static_cast<std::size_t>(result.dims.z));
  const double low = (volume.range.low - volume.intercept) / volume.slope;
  const double high = (volume.range.high - volume.intercept) / volume.slope;
  volume.voxels.visit([&](auto scalars) {
    using T = typename decltype(scalars)::value_type;
    const T lowest = static_cast<T>(std::min(low, high)), highest = static_cast<T>(std::max(low, high));
    const T standIn = static_cast<T>(low);  // for NaN: the least real value
    parallelFor(static_cast<std::size_t>(result.dims.z), 1, [&](std::size_t zBegin, std::size_t zEnd) {
      std::vector<T> least(static_cast<std::size_t>(result.dims.x)), greatest(least.size());
      for (int bz = static_cast<int>(zBegin); bz < static_cast<int>(zEnd); ++bz)
        for (int by = 0; by < result.dims.y; ++by) {
          std::fill(least.begin(), least.end(), std::numeric_limits<T>::max());
          std::fill(greatest.begin(), greatest.end(), std::numeric_limits<T>::lowest());
          // Corners of a brick's cells are the voxels from one before them on, clamped to the volume.
          for (int z = std::max(bz * brickSide - 1, 0); z <= std::min(bz * brickSide + brickSide - 1, dims.z - 1); ++z)
            for (int y = std::max(by * brickSide - 1, 0); y <= std::min(by * brickSide + brickSide - 1, dims.y - 1);
                 ++y) {
              const T* row = scalars.data() + volume.grid.offset({0, y, z});
              for (int bx = 0; bx < result.dims.x; ++bx) {
                T minimum = least[static_cast<std::size_t>(bx)], maximum = greatest[static_cast<std::size_t>(bx)];
                for (int x = std::max(bx * brickSide - 1, 0); x <= std::min(bx * brickSide + brickSide - 1, dims.x - 1);
                     ++x) {
                  T scalar = row[x];
                  if constexpr (std::is_floating_point_v<T>)
                    scalar = std::isnan(scalar) ? standIn : std::clamp(scalar, lowest, highest);
                  minimum = std::min(minimum, scalar);
                  maximum = std::max(maximum, scalar);
                }
                least[static_cast<std::size_t>(bx)] = minimum;
                greatest[static_cast<std::size_t>(bx)] = maximum;
              }
            }
          for (int bx = 0; bx < result.dims.x; ++bx) {
            // The last brick of a side may hold no voxel of its own: it repeats the clamped edge.
            if (least[static_cast<std::size_t>(bx)] > greatest[static_cast<std::size_t>(bx)]) {
              result.ranges[brickOffset(result.dims, {bx, by, bz})] = volume.range;
              continue;
            }
            const double a = volume.slope * static_cast<double>(least[static_cast<std::size_t>(bx)]) + volume.intercept;
            const double b =
                volume.slope * static_cast<double>(greatest[static_cast<std::size_t>(bx)]) + volume.intercept;
            result.ranges[brickOffset(result.dims, {bx, by, bz})] = {std::min(a, b), std::max(a, b)};
          }
        }
    });
  });
  return result;
}

std::vector<std::uint8_t> chebyshevDistance(glm::ivec3 dims, const std::vector<std::uint8_t>& occupied) {
  std::vector<std::uint8_t> distance(occupied.size());
  for (std::size_t i = 0; i < occupied.size(); ++i) distance[i] = occupied[i] ? 0 : 255;
  // Two sweeps with unit weights over the 26 neighbours are exact for this metric (Borgefors 1986).
  const auto relax = [&](int x, int y, int z, int direction) {
    std::uint8_t& here = distance[brickOffset(dims, {x, y, z})];
    if (here == 0) return;
    for (int dz = -1; dz <= 1; ++dz)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if ((dz * 9 + dy * 3 + dx) * direction >= 0) continue;
          const int nx = x + dx, ny = y + dy, nz = z + dz;
          if (nx < 0 || ny < 0 || nz < 0 || nx >= dims.x || ny >= dims.y || nz >= dims.z) continue;
          const std::uint8_t there = distance[brickOffset(dims, {nx, ny, nz})];
          if (there < here) here = static_cast<std::uint8_t>(std::min<int>(here, there + 1));
        }
  };
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) relax(x, y, z, 1);
  for (int z = dims.z - 1; z >= 0; --z)
    for (int y = dims.y - 1; y >= 0; --y)
      for (int x = dims.x - 1; x >= 0; --x) relax(x, y, z, -1);
  return distance;
}

}  // namespace fenestra
