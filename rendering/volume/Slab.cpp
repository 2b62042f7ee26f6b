#include "rendering/volume/Slab.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "rendering/volume/SlabJob.h"
#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

/// Voxels that are copied at once; they fit in a core's own memory.
constexpr std::int64_t boxVoxels = 1 << 16;
/// Voxels along a line after which positions are computed anew in double precision: until then, float32 keeps them to a
/// millionth of a voxel.
constexpr double pieceVoxels = 32.0;

void put(double (&to)[3], glm::dvec3 from) {
  for (int axis = 0; axis < 3; ++axis) to[axis] = from[axis];
}

/// The lines of a slab, and their part [from, to] that can meet the volume.
struct SlabJob {
  SlabLines lines;
  glm::dvec3 first{0.0}, right{0.0}, down{0.0}, along{0.0};
  /// How pixel column, pixel row and mm along the lines grow from voxel to voxel of each axis.
  std::array<glm::dvec3, 3> growth{};
  std::array<double, 3> reach{};  ///< by so much of them a cell reaches to each side, and a little more
  double from = std::numeric_limits<double>::infinity(), to = -from;
  int pieces = 0;

  double end(int piece) const { return from + (to - from) * piece / pieces; }
};

SlabJob slabJob(const Volume& volume, const SliceGeometry& geometry, int slice, const Slab& slab) {
  const Grid& grid = volume.grid;
  const glm::dmat3 linear(grid.indexFromWorld());
  // In a sheared grid, the step from slice to slice is not perpendicular to them.
  const glm::dvec3 normal = glm::normalize(glm::cross(geometry.right, geometry.down));
  // Subtracting the origins first keeps the precision where both are metres away.
  const glm::dvec3 corner = geometry.worldFromPixel(0, 0, slice);
  SlabJob job;
  job.first = linear * (corner - grid.origin);
  job.right = linear * geometry.right;
  job.down = linear * geometry.down;
  job.along = linear * normal;
  const double greatest = std::max({std::abs(job.along.x), std::abs(job.along.y), std::abs(job.along.z)});
  // What rounding left of an axis that the lines do not follow would move them by no thousandth of a voxel.
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(job.along[axis]) < 1e-9 * greatest) job.along[axis] = 0.0;
  const glm::dmat3 fromIndex = glm::transpose(glm::inverse(glm::dmat3(job.right, job.down, job.along)));
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(k);
    job.growth[at] = fromIndex[k];
    job.reach[at] = 1.1 * (std::abs(fromIndex[k].x) + std::abs(fromIndex[k].y) + std::abs(fromIndex[k].z));
  }
  for (const glm::dvec3 of : grid.corners()) {
    job.from = std::min(job.from, glm::dot(of - corner, normal));
    job.to = std::max(job.to, glm::dot(of - corner, normal));
  }
  job.from = std::max(job.from, -0.5 * slab.thickness);
  job.to = std::min(job.to, 0.5 * slab.thickness);
  if (job.from < job.to)
    job.pieces = std::max(1, static_cast<int>(std::ceil((job.to - job.from) * greatest / pieceVoxels)));

  put(job.lines.first, job.first);
  put(job.lines.right, job.right);
  put(job.lines.down, job.down);
  put(job.lines.along, job.along);
  put(job.lines.low, glm::dvec3(-0.5));
  put(job.lines.high, glm::dvec3(grid.dims) - 0.5);
  job.lines.sign = (slab.mode == SlabMode::Maximum) == (volume.slope >= 0.0) ? 1.0 : -1.0;
  return job;
}

/// Voxels [first, last].
struct VoxelRange {
  glm::ivec3 first, last;
  glm::ivec3 size() const { return glm::max(last - first + 1, 0); }
  std::int64_t count() const {
    const glm::ivec3 s = size();
    return std::int64_t{s.x} * s.y * s.z;
  }
};

/// The voxels that a piece of a tile's lines reads; none where it misses the volume.
VoxelRange voxelsOf(const SlabJob& job, const SlabTile& tile, int piece, glm::ivec3 dims) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const double i = corner & 1 ? tile.right - 1 : tile.left, j = corner & 2 ? tile.bottom - 1 : tile.top;
    const glm::dvec3 at =
        job.first + i * job.right + j * job.down + job.end(corner & 4 ? piece + 1 : piece) * job.along;
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  low = glm::max(low, glm::dvec3(-1.0));
  high = glm::min(high, glm::dvec3(dims));
  if (glm::any(glm::greaterThan(low, high))) return {glm::ivec3(0), glm::ivec3(-1)};
  // A cell ends at the next voxel. One more to each side allows for rounding.
  return {glm::ivec3(glm::floor(low)) - 1, glm::ivec3(glm::floor(high)) + 2};
}

/// As int16 where that holds all values of the type, uint16 less 32768.
template <class T>
using BoxScalar = std::conditional_t<sizeof(T) <= 2, std::int16_t, double>;
template <class T>
constexpr double boxOffset = std::is_same_v<T, std::uint16_t> ? 32768.0 : 0.0;

template <class T>
BoxScalar<T> boxScalar(T stored) {
  if constexpr (std::is_same_v<T, std::uint16_t>)
    return static_cast<std::int16_t>(stored ^ 0x8000);
  else
    return static_cast<BoxScalar<T>>(stored);
}

/// Rows of voxels that are asked for before they are copied: they lie far from one another in memory, and most of the
/// time of copying them passed in waiting for the first voxel of each.
constexpr int rowsAhead = 4;

/// Asks for the voxels [first, last] of a row.
template <class T>
void prefetch(const T* row, int first, int last) {
  constexpr int line = 64 / static_cast<int>(sizeof(T));  // of a processor's cache
  for (int x = first; x < last; x += line) __builtin_prefetch(row + x);
  __builtin_prefetch(row + last);
}

/// The space about the lines of a tile in a piece of the slab, with all voxels that they read. Of the box about oblique
/// lines, much is other voxels.
class Prism {
 public:
  /// `first`: the first voxel of the box.
  Prism(const SlabJob& job, const SlabTile& tile, int piece, glm::ivec3 first) : first_(first) {
    const double low[3] = {1.0 * tile.left, 1.0 * tile.top, job.end(piece)};
    const double high[3] = {tile.right - 1.0, tile.bottom - 1.0, job.end(piece + 1)};
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = glm::dot(job.growth[k], glm::dvec3(first) - job.first);
      Side& side = sides_[k];
      side = {.growth = job.growth[k], .low = low[k] - job.reach[k] - at, .high = high[k] + job.reach[k] - at};
      // A row of a million voxels would leave it by no more than is allowed for rounding.
      side.isAlong = std::abs(side.growth.x) < 1e-7 * job.reach[k];
      side.perX = side.isAlong ? 0.0 : 1.0 / side.growth.x;
    }
  }

  /// Which of the `count` voxels of a row of the box lie within: [first, end).
  std::pair<int, int> row(int y, int z, int count) const {
    double begin = 0.0, end = count - 1.0;
    for (const Side& side : sides_) {
      const double at = side.growth.y * (y - first_.y) + side.growth.z * (z - first_.z);
      if (side.isAlong) {
        if (at < side.low || at > side.high) return {0, 0};
        continue;
      }
      const double a = (side.low - at) * side.perX, b = (side.high - at) * side.perX;
      begin = std::max(begin, std::min(a, b));
      end = std::min(end, std::max(a, b));
    }
    if (!(begin <= end)) return {0, 0};
    return {static_cast<int>(begin), static_cast<int>(end) + 1};
  }

 private:
  /// Between two planes: growth · position lies in [low, high], positions counted from the box's first voxel.
  struct Side {
    glm::dvec3 growth;
    double low, high;
    double perX = 0.0;     ///< 1 / growth.x
    bool isAlong = false;  ///< rows do not leave it
  };
  glm::ivec3 first_;
  std::array<Side, 3> sides_;
};

/// Computes a slab tile by tile, on one thread.
template <class T>
class SlabTiles {
 public:
  SlabTiles(const Volume& volume, const SlabJob& job, SlabMode mode, int width, float* values)
      : volume_(volume),
        job_(job),
        isMean_(mode == SlabMode::Mean),
        kernel_(slabKernels(isMean_, sizeof(T) <= 2).front()),
        width_(width),
        values_(values) {}

  void compute(const SlabTile& tile) {
    const glm::ivec3 dims = volume_.grid.dims;
    std::int64_t most = 0;
    for (int piece = 0; piece < job_.pieces; ++piece) most = std::max(most, voxelsOf(job_, tile, piece, dims).count());
    const int across = tile.right - tile.left, down = tile.bottom - tile.top;
    if (most > boxVoxels && std::max(across, down) > 1) {
      // Large pixels: the lines are far from one another.
      SlabTile first = tile, second = tile;
      if (across >= down)
        first.right = second.left = tile.left + across / 2;
      else
        first.bottom = second.top = tile.top + down / 2;
      compute(first);
      compute(second);
      return;
    }
    const auto pixels = static_cast<std::size_t>(across * down);
    std::fill_n(sums_.extreme, pixels, -std::numeric_limits<double>::infinity());
    std::fill_n(sums_.sum, pixels, 0.0);
    std::fill_n(sums_.length, pixels, 0.0);
    for (int piece = 0; piece < job_.pieces; ++piece) {
      const VoxelRange range = voxelsOf(job_, tile, piece, dims);
      if (range.count() == 0) continue;
      kernel_(job_.lines, copy(range, tile, piece), tile, job_.end(piece), job_.end(piece + 1), sums_);
    }
    write(tile);
  }

 private:
  SlabBox copy(const VoxelRange& range, const SlabTile& tile, int piece) {
    const glm::ivec3 last = volume_.grid.dims - 1;
    SlabBox box;
    box.row = range.size().x;
    box.plane = range.size().x * range.size().y;
    put(box.first, glm::dvec3(range.first));
    voxels_.resize(static_cast<std::size_t>(range.count()) + 1);
    box.voxels = voxels_.data();
    const std::span<const T> stored = volume_.voxels.as<T>();
    const auto rowOf = [&](int y, int z) {
      return stored.data() + volume_.grid.offset({0, std::clamp(y, 0, last.y), std::clamp(z, 0, last.z)});
    };
    const Prism prism(job_, tile, piece, range.first);
    BoxScalar<T>* to = voxels_.data();
    for (int z = range.first.z; z <= range.last.z; ++z)
      for (int y = range.first.y; y <= range.last.y; ++y, to += box.row) {
        const auto [first, end] = prism.row(y, z, box.row);
        if (first == end) continue;
        const int begin = range.first.x + first, behind = range.first.x + end;
        prefetch(rowOf(y + rowsAhead, z), std::clamp(begin, 0, last.x), std::clamp(behind - 1, 0, last.x));
        const T* const row = rowOf(y, z);
        // Counted in the box's row, the volume's own voxels begin and end here.
        const int left = std::clamp(-range.first.x, first, end),
                  right = std::clamp(last.x + 1 - range.first.x, left, end);
        std::fill(to + first, to + left, boxScalar(row[0]));
        for (int x = left; x < right; ++x) to[x] = boxScalar(row[range.first.x + x]);
        std::fill(to + right, to + end, boxScalar(row[last.x]));
      }
    return box;
  }

  void write(const SlabTile& tile) const {
    std::size_t pixel = 0;
    for (int j = tile.top; j < tile.bottom; ++j)
      for (int i = tile.left; i < tile.right; ++i, ++pixel) {
        double value = std::numeric_limits<double>::quiet_NaN();
        if (isMean_ && sums_.length[pixel] > 0.0) value = sums_.sum[pixel] / sums_.length[pixel];
        if (!isMean_ && sums_.extreme[pixel] > -std::numeric_limits<double>::infinity())
          value = job_.lines.sign * sums_.extreme[pixel];
        values_[static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(i)] =
            static_cast<float>(volume_.slope * (value + boxOffset<T>)+volume_.intercept);
      }
  }

  const Volume& volume_;
  const SlabJob& job_;
  const bool isMean_;
  const SlabKernel kernel_;
  const int width_;
  float* const values_;
  std::vector<BoxScalar<T>> voxels_;  ///< and one more: voxels are read in pairs
  SlabSums sums_;
};

}  // namespace

std::vector<float> slabValues(const Volume& volume, const SliceGeometry& geometry, int slice, const Slab& slab) {
  assert(std::isfinite(slab.thickness) && slab.thickness >= 0.0);
  if (slab.thickness == 0.0) return sliceValues(volume, geometry, slice);
  const SlabJob job = slabJob(volume, geometry, slice, slab);
  const int width = geometry.width, height = geometry.height;
  std::vector<float> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  // Cores take tiles in turns, because those outside the volume take no time.
  constexpr int side = SlabTile::side;
  const int across = (width + side - 1) / side, tiles = across * ((height + side - 1) / side);
  std::atomic<int> next = 0;
  volume.voxels.visit([&](auto scalars) {
    onEachCore([&](bool) {
      SlabTiles<typename decltype(scalars)::value_type> computed(volume, job, slab.mode, width, values.data());
      for (int tile = next++; tile < tiles; tile = next++) {
        interruptionPoint();
        const int left = tile % across * side, top = tile / across * side;
        computed.compute({left, top, std::min(left + side, width), std::min(top + side, height)});
      }
    });
  });
  return values;
}

}  // namespace fenestra
