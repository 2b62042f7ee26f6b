#include "rendering/gpu/Bricks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "rendering/gpu/WideRows.h"
#include "rendering/volume/Threads.h"

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

namespace {

constexpr int octantSide = brickSide / 2;

double valueAtStep(const ValueRange& brick, int step) {
  return step == 255 ? brick.high : brick.low + step * (brick.high - brick.low) / 255.0;
}

/// The nearest steps that have `range` between them, in a brick of more than one value.
void setOctant(OctantRanges& octants, std::size_t octant, const ValueRange& range, const ValueRange& brick) {
  const double perStep = 255.0 / (brick.high - brick.low);
  int low = std::clamp(static_cast<int>((range.low - brick.low) * perStep), 0, 255);
  int high = std::clamp(static_cast<int>(std::ceil((range.high - brick.low) * perStep)), 0, 255);
  // Rounding may have carried either past the range.
  while (low > 0 && valueAtStep(brick, low) > range.low) --low;
  while (high < 255 && valueAtStep(brick, high) < range.high) ++high;
  octants.low[octant] = static_cast<std::uint8_t>(low);
  octants.high[octant] = static_cast<std::uint8_t>(high);
}

/// First and last voxel, along one axis, at corners of an octant's cells; the last lies before the first where the
/// octant has no cells.
std::pair<int, int> voxelsOf(int octant, int dims) {
  return {std::max(octant * octantSide - 1, 0), std::min(octant * octantSide + octantSide - 1, dims - 1)};
}

template <class T>
inline void joinValues(const T* row, std::size_t count, T* low, T* high) {
  for (std::size_t x = 0; x < count; ++x) {
    low[x] = std::min(low[x], row[x]);
    high[x] = std::max(high[x], row[x]);
  }
}

/// Widens the range at each x by the row's value there.
template <class T>
void joinRow(const T* row, std::size_t count, T* low, T* high) {
  joinValues(row, count, low, high);
}
FENESTRA_WIDE_ROWS void joinRow(const std::int16_t* row, std::size_t count, std::int16_t* low, std::int16_t* high) {
  joinValues(row, count, low, high);
}
FENESTRA_WIDE_ROWS void joinRow(const std::uint16_t* row, std::size_t count, std::uint16_t* low, std::uint16_t* high) {
  joinValues(row, count, low, high);
}

/// Least and greatest stored value of the octants of a layer of bricks, x fastest.
template <class T>
class OctantLayer {
 public:
  explicit OctantLayer(glm::ivec3 bricks)
      : dims_(2 * bricks.x, 2 * bricks.y, 2), ends_(brickOffset(dims_, {0, 0, dims_.z})) {}

  /// `read`: scalars of a row of voxels, by y and z.
  template <class Read>
  void fill(int layer, glm::ivec3 voxels, Read read) {
    const auto width = static_cast<std::size_t>(voxels.x);
    low_.resize(width);
    high_.resize(width);
    for (int z = 0; z < 2; ++z) {
      const auto [zFirst, zLast] = voxelsOf(2 * layer + z, voxels.z);
      for (int y = 0; y < dims_.y; ++y) {
        const auto [yFirst, yLast] = voxelsOf(y, voxels.y);
        // The rows are joined first, which vectorizes.
        std::fill(low_.begin(), low_.end(), Ends().low);
        std::fill(high_.begin(), high_.end(), Ends().high);
        for (int vz = zFirst; vz <= zLast; ++vz)
          for (int vy = yFirst; vy <= yLast; ++vy) joinRow(read(vy, vz), width, low_.data(), high_.data());
        Ends* octants = ends_.data() + brickOffset(dims_, {0, y, z});
        for (int x = 0; x < dims_.x; ++x) {
          const auto [first, last] = voxelsOf(x, voxels.x);
          octants[x] = Ends();
          for (int vx = first; vx <= last; ++vx)
            octants[x].take(low_[static_cast<std::size_t>(vx)], high_[static_cast<std::size_t>(vx)]);
        }
      }
    }
  }

  struct Ends {
    T low = std::numeric_limits<T>::max(), high = std::numeric_limits<T>::lowest();
    void take(T least, T greatest) {
      low = std::min(low, least);
      high = std::max(high, greatest);
    }
    bool any() const { return low <= high; }
  };
  const Ends& octant(glm::ivec3 at) const { return ends_[brickOffset(dims_, at)]; }

 private:
  glm::ivec3 dims_;
  std::vector<Ends> ends_;
  std::vector<T> low_, high_;  ///< of a row of octants, by voxel
};

}  // namespace

ValueRange rangeOf(const OctantRanges& octants, std::size_t octant, const ValueRange& brick) {
  return {valueAtStep(brick, octants.low[octant]), valueAtStep(brick, octants.high[octant])};
}

BrickRanges brickRanges(const ShownVolume& shown, WithOctants octants) {
  const Volume& volume = *shown.volume;
  const ShownVoxels voxels(shown);
  const glm::ivec3 dims = volume.grid.dims;
  BrickRanges result;
  result.dims = brickCount(dims);
  result.ranges.resize(brickOffset(result.dims, {0, 0, result.dims.z}));
  if (octants == WithOctants::Yes) result.octants.resize(result.ranges.size());
  const double low = (volume.range.low - volume.intercept) / volume.slope;
  const double high = (volume.range.high - volume.intercept) / volume.slope;
  volume.voxels.visit([&](auto scalars) {
    using T = typename decltype(scalars)::value_type;
    const T lowest = static_cast<T>(std::min(low, high)), highest = static_cast<T>(std::max(low, high));
    const T standIn = static_cast<T>(low);  // for NaN: the least real value
    const auto realOf = [&](const typename OctantLayer<T>::Ends& ends) {
      const double a = volume.slope * static_cast<double>(ends.low) + volume.intercept;
      const double b = volume.slope * static_cast<double>(ends.high) + volume.intercept;
      return ValueRange{std::min(a, b), std::max(a, b)};
    };
    parallelFor(static_cast<std::size_t>(result.dims.z), 1, [&](std::size_t zBegin, std::size_t zEnd) {
      OctantLayer<T> layer(result.dims);
      std::vector<T> buffer, finite(static_cast<std::size_t>(dims.x));
      for (int bz = static_cast<int>(zBegin); bz < static_cast<int>(zEnd); ++bz) {
        layer.fill(bz, dims, [&](int y, int z) -> const T* {
          const T* row = voxels.row(y, z, buffer);
          if constexpr (!std::is_floating_point_v<T>) return row;
          std::transform(row, row + dims.x, finite.begin(), [&](T scalar) {
            return std::isnan(static_cast<double>(scalar)) ? standIn : std::clamp(scalar, lowest, highest);
          });
          return finite.data();
        });
        for (int by = 0; by < result.dims.y; ++by)
          for (int bx = 0; bx < result.dims.x; ++bx) {
            const auto octantAt = [&](int i) {
              return layer.octant({2 * bx + (i & 1), 2 * by + (i >> 1 & 1), i >> 2});
            };
            typename OctantLayer<T>::Ends whole;
            for (int i = 0; i < 8; ++i) whole.take(octantAt(i).low, octantAt(i).high);
            const std::size_t brick = brickOffset(result.dims, {bx, by, bz});
            result.ranges[brick] = realOf(whole);
            if (result.octants.empty() || !(result.ranges[brick].high > result.ranges[brick].low)) continue;
            for (int i = 0; i < 8; ++i)
              if (octantAt(i).any())
                setOctant(result.octants[brick], static_cast<std::size_t>(i), realOf(octantAt(i)),
                          result.ranges[brick]);
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

std::vector<std::uint16_t> skipTexels(glm::ivec3 dims, const std::vector<OctantMask>& occupied) {
  const std::vector<std::uint8_t> distance = chebyshevDistance(dims, occupied);
  std::vector<std::uint16_t> texels(distance.size());
  std::transform(distance.begin(), distance.end(), occupied.begin(), texels.begin(),
                 [](int steps, int shown) { return static_cast<std::uint16_t>(steps | shown << 8); });
  return texels;
}

}  // namespace fenestra
