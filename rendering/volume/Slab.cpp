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
  glm::dvec3 mm{0.0};  ///< across the slab, from voxel to voxel of each axis
  double reach = 0.0;  ///< mm: a cell reaches so far across the slab, and a little more
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
  job.mm = glm::transpose(glm::dmat3(grid.worldFromIndex())) * normal;
  job.reach = 1.1 * (std::abs(job.mm.x) + std::abs(job.mm.y) + std::abs(job.mm.z));
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

/// Computes a slab tile by tile, on one thread.
template <class T>
class SlabTiles {
 public:
  SlabTiles(const Volume& volume, const SlabJob& job, SlabMode mode, int width, float* values)
      : volume_(volume),
        job_(job),
        isMean_(mode == SlabMode::Mean),
        kernel_(slabKernel(isMean_, sizeof(T) <= 2)),
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
      kernel_(job_.lines, copy(range, piece), tile, job_.end(piece), job_.end(piece + 1), sums_);
    }
    write(tile);
  }

 private:
  SlabBox copy(const VoxelRange& range, int piece) {
    const glm::ivec3 last = volume_.grid.dims - 1;
    SlabBox box;
    box.row = range.size().x;
    box.plane = range.size().x * range.size().y;
    put(box.first, glm::dvec3(range.first));
    voxels_.resize(static_cast<std::size_t>(range.count()) + 1);
    box.voxels = voxels_.data();
    const std::span<const T> stored = volume_.voxels.as<T>();
    BoxScalar<T>* to = voxels_.data();
    for (int z = range.first.z; z <= range.last.z; ++z)
      for (int y = range.first.y; y <= range.last.y; ++y, to += box.row) {
        const auto [first, end] = read({range.first.x, y, z}, box.row, piece);
        const T* const row =
            stored.data() + volume_.grid.offset({0, std::clamp(y, 0, last.y), std::clamp(z, 0, last.z)});
        // Counted in the box's row, the volume's own voxels begin and end here.
        const int left = std::clamp(-range.first.x, first, end),
                  right = std::clamp(last.x + 1 - range.first.x, left, end);
        std::fill(to + first, to + left, boxScalar(row[0]));
        for (int x = left; x < right; ++x) to[x] = boxScalar(row[range.first.x + x]);
        std::fill(to + right, to + end, boxScalar(row[last.x]));
      }
    return box;
  }

  /// Which of `count` voxels of a row, the first of which is `at`, lie within a voxel of the piece of the slab: [first,
  /// end). Of the box about oblique lines, much does not.
  std::pair<int, int> read(glm::dvec3 at, int count, int piece) const {
    const glm::dvec3& mm = job_.mm;
    const double first = glm::dot(mm, at - job_.first);
    const double low = job_.end(piece) - job_.reach - first, high = job_.end(piece + 1) + job_.reach - first;
    if (std::abs(mm.x) * count < 0.01 * job_.reach)
      return low <= 0.0 && high >= 0.0 ? std::pair(0, count) : std::pair(0, 0);
    const double a = std::min(low / mm.x, high / mm.x), b = std::max(low / mm.x, high / mm.x);
    const int begin = static_cast<int>(std::ceil(std::clamp(a, 0.0, 1.0 * count)));
    return {begin, std::max(begin, static_cast<int>(std::floor(std::clamp(b, -1.0, count - 1.0))) + 1)};
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
