#include "rendering/gpu/Bricks.h"

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

BrickRanges brickRanges(const ShownVolume& shown) {
  const Volume& volume = *shown.volume;
  const ShownVoxels voxels(shown);
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
      std::vector<T> least(static_cast<std::size_t>(result.dims.x)), greatest(least.size()), buffer;
      for (int bz = static_cast<int>(zBegin); bz < static_cast<int>(zEnd); ++bz)
        for (int by = 0; by < result.dims.y; ++by) {
          std::fill(least.begin(), least.end(), std::numeric_limits<T>::max());
          std::fill(greatest.begin(), greatest.end(), std::numeric_limits<T>::lowest());
          // Corners of a brick's cells are the voxels from one before them on, clamped to the volume.
          for (int z = std::max(bz * brickSide - 1, 0); z <= std::min(bz * brickSide + brickSide - 1, dims.z - 1); ++z)
            for (int y = std::max(by * brickSide - 1, 0); y <= std::min(by * brickSide + brickSide - 1, dims.y - 1);
                 ++y) {
              const T* row = voxels.row(y, z, buffer);
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
  std::transform(occupied.begin(), occupied.end(), distance.begin(),
                 [](std::uint8_t shows) { return static_cast<std::uint8_t>(shows ? 0 : 255); });
  const auto width = static_cast<std::size_t>(dims.x);
  // Least of the rows already swept around one, with an end repeated at either side.
  std::vector<std::uint8_t> around(width + 2);
  const auto farther = [](std::uint8_t value) { return static_cast<std::uint8_t>(value + (value < 255)); };
  // A brick's nearest one along its row, in steps of twice the length: no brick waits for the one beside it, so that
  // processors do many at once.
  std::vector<std::uint8_t> before(width);
  const auto sweepRow = [&](std::uint8_t* row, int direction) {
    for (std::size_t step = 1; step < std::min(width, std::size_t{255}); step *= 2) {
      std::copy_n(row, width, before.begin());
      const std::uint8_t* near = before.data() + (direction > 0 ? 0 : step);
      std::uint8_t* to = row + (direction > 0 ? step : 0);
      const auto most = static_cast<std::uint8_t>(255 - step), length = static_cast<std::uint8_t>(step);
      for (std::size_t x = 0; x < width - step; ++x)
        to[x] = std::min(to[x], static_cast<std::uint8_t>(std::min(near[x], most) + length));
    }
  };
  // Two sweeps with unit weights over the 26 neighbours are exact for this metric (Borgefors 1986). Of a row's 13
  // before it, 12 lie in other rows and are taken for the whole row at once.
  const auto sweep = [&](int direction) {
    const int zFirst = direction > 0 ? 0 : dims.z - 1, yFirst = direction > 0 ? 0 : dims.y - 1;
    for (int z = zFirst; z >= 0 && z < dims.z; z += direction)
      for (int y = yFirst; y >= 0 && y < dims.y; y += direction) {
        std::fill(around.begin(), around.end(), std::uint8_t{255});
        const auto take = [&](int ny, int nz) {
          if (ny < 0 || nz < 0 || ny >= dims.y || nz >= dims.z) return;
          const std::uint8_t* row = distance.data() + brickOffset(dims, {0, ny, nz});
          for (std::size_t x = 0; x < width; ++x) around[x + 1] = std::min(around[x + 1], row[x]);
        };
        take(y - direction, z);
        for (int dy = -1; dy <= 1; ++dy) take(y + dy, z - direction);
        around.front() = around[1];
        around.back() = around[width];
        std::uint8_t* row = distance.data() + brickOffset(dims, {0, y, z});
        for (std::size_t x = 0; x < width; ++x)
          row[x] = std::min(row[x], farther(std::min({around[x], around[x + 1], around[x + 2]})));
        sweepRow(row, direction);
      }
  };
  sweep(1);
  sweep(-1);
  return distance;
}

}  // namespace fenestra
