#include "rendering/segmentation/TissueCells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

constexpr double mostCells = 3e6;
constexpr float leastEdge = 1.0f;  ///< units of the noise: edges with less are not sharpened

/// The greatest sides that reach no farther than a length in mm, one voxel at least, and the least such length that
/// leaves mostCells at most. Where voxels are few, each is a cell, however thick its slice is: a cell of several would
/// be coarser in the plane than what a reader sees there.
glm::ivec3 cellSizeOf(const Grid& grid) {
  glm::ivec3 size(1);
  const auto countOf = [&] { return static_cast<double>(wholeOf((grid.dims + size - 1) / size).count()); };
  while (countOf() > mostCells) {
    double length = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
      if (size[axis] < grid.dims[axis]) length = std::min(length, (size[axis] + 1) * grid.spacing[axis]);
    for (int axis = 0; axis < 3; ++axis)
      size[axis] =
          static_cast<int>(std::clamp(length / grid.spacing[axis] + 1e-6, 1.0, static_cast<double>(grid.dims[axis])));
  }
  return size;
}

/// The means of a row of cells; `cells` are those of the row.
template <class T>
void meansOf(std::span<const T> scalars, const Volume& volume, glm::ivec3 size, const VoxelBox& voxels,
             std::span<float> cells) {
  std::vector<double> sums(cells.size(), 0.0);
  for (int z = voxels.low.z; z < voxels.high.z; ++z)
    for (int y = voxels.low.y; y < voxels.high.y; ++y) {
      const T* row = scalars.data() + volume.grid.offset({0, y, z});
      for (int cell = 0, x = 0; x < voxels.high.x; ++cell)
        for (const int end = std::min(x + size.x, voxels.high.x); x < end; ++x)
          sums[static_cast<std::size_t>(cell)] += finiteValue(row[x], volume);
    }
  const int across = voxels.dims().y * voxels.dims().z;
  for (int cell = 0; cell < static_cast<int>(cells.size()); ++cell) {
    const int along = std::min(size.x, voxels.high.x - cell * size.x);
    cells[static_cast<std::size_t>(cell)] =
        static_cast<float>(sums[static_cast<std::size_t>(cell)] / static_cast<double>(along * across));
  }
}

/// The means of the cells as a volume.
Volume reduced(const Volume& volume, glm::ivec3 size) {
  Volume cells;
  cells.grid = volume.grid;
  cells.grid.dims = (volume.grid.dims + size - 1) / size;
  cells.grid.spacing = volume.grid.spacing * glm::dvec3(size);
  cells.modality = volume.modality;
  cells.unit = volume.unit;
  cells.windows = volume.windows;
  cells.voxels = Voxels(ScalarType::Float32, cells.grid.voxelCount());
  const std::span<float> means = cells.voxels.as<float>();
  const VoxelBox whole = wholeOf(cells.grid.dims);
  volume.voxels.visit([&](auto scalars) {
    const std::size_t row = static_cast<std::size_t>(cells.grid.dims.x);
    parallelFor(means.size() / row, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const glm::ivec3 low = whole.at(i * row) * size;
        const VoxelBox voxels = VoxelBox{low, {volume.grid.dims.x, low.y + size.y, low.z + size.z}};
        meansOf(scalars, volume, size, voxels.clippedTo(wholeOf(volume.grid.dims)), means.subspan(i * row, row));
      }
    });
  });
  cells.computeRange();
  return cells;
}

/// Each cell on an edge takes the tone of its brightest or darkest neighbour, whichever is nearer: Kramer, Bruckner,
/// see EdgeSharpener.
std::vector<float> sharpened(const std::vector<float>& tones, const CellNeighbours& cells) {
  std::vector<float> low = tones, high = tones, result = tones;
  cells.forPairs([&](std::size_t a, std::size_t b, int, glm::ivec3) {
    low[a] = std::min(low[a], tones[b]);
    high[a] = std::max(high[a], tones[b]);
    low[b] = std::min(low[b], tones[a]);
    high[b] = std::max(high[b], tones[a]);
  });
  for (std::size_t i = 0; i < result.size(); ++i)
    if (high[i] - low[i] > leastEdge) result[i] = tones[i] - low[i] < high[i] - tones[i] ? low[i] : high[i];
  return result;
}

/// By cell: the greatest difference to a neighbour.
std::vector<float> gradientsOf(const std::vector<float>& tones, const CellNeighbours& cells) {
  std::vector<float> gradient(tones.size(), 0.0f);
  cells.forPairs([&](std::size_t a, std::size_t b, int, glm::ivec3) {
    const float difference = std::abs(tones[a] - tones[b]);
    gradient[a] = std::max(gradient[a], difference);
    gradient[b] = std::max(gradient[b], difference);
  });
  return gradient;
}

/// By cell: the neighbour of the least gradient, itself where none has less. Ties go to the first.
std::vector<std::uint32_t> descents(const std::vector<float>& gradient, const CellNeighbours& cells) {
  const auto isLower = [&](std::size_t a, std::size_t b) {
    return gradient[a] < gradient[b] || (gradient[a] == gradient[b] && a < b);
  };
  std::vector<std::uint32_t> next(gradient.size());
  std::iota(next.begin(), next.end(), std::uint32_t{0});
  cells.forPairs([&](std::size_t a, std::size_t b, int, glm::ivec3) {
    if (isLower(b, next[a])) next[a] = static_cast<std::uint32_t>(b);
    if (isLower(a, next[b])) next[b] = static_cast<std::uint32_t>(a);
  });
  return next;
}

/// The lowest cell that the ways from a cell lead to; the ways are shortened as they are walked.
std::uint32_t lowestFrom(std::uint32_t cell, std::vector<std::uint32_t>& next) {
  std::uint32_t lowest = cell;
  while (next[lowest] != lowest) lowest = next[lowest];
  for (std::uint32_t at = cell; at != lowest;) at = std::exchange(next[at], lowest);
  return lowest;
}

}  // namespace

TissueCells tissueCells(const Volume& volume) {
  TissueCells cells;
  cells.size = cellSizeOf(volume.grid);
  const Volume means = reduced(volume, cells.size);
  cells.grid = means.grid;
  cells.noise = noiseOf(means);
  const bool isCt = volume.isInHounsfieldUnits();
  const WindowLevel window = means.defaultWindow();
  cells.reference = isCt ? softTissue : window.level;
  const ToneScale scale(means, cells.noise, cells.reference);
  cells.tones = sharpened(smoothedTones(means, wholeOf(means.grid.dims), scale), CellNeighbours(means.grid));
  const double air = isCt ? gasBelow : window.level - 0.5 * window.width;
  const std::span<const float> values = means.voxels.as<float>();
  const auto body = std::count_if(values.begin(), values.end(), [&](float value) { return value >= air; });
  cells.bodyVolume = static_cast<double>(body) * means.grid.voxelVolume();
  return cells;
}

CellNeighbours::CellNeighbours(const Grid& grid)
    : dims_(grid.dims),
      steps_{1, static_cast<std::size_t>(dims_.x),
             static_cast<std::size_t>(dims_.x) * static_cast<std::size_t>(dims_.y)} {
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 a = grid.direction[(axis + 1) % 3] * grid.spacing[(axis + 1) % 3];
    const glm::dvec3 b = grid.direction[(axis + 2) % 3] * grid.spacing[(axis + 2) % 3];
    faceArea_[axis] = glm::length(glm::cross(a, b));
  }
}

Basins basinsOf(const std::vector<float>& tones, const CellNeighbours& cells) {
  const std::vector<float> gradient = gradientsOf(tones, cells);
  std::vector<std::uint32_t> next = descents(gradient, cells);
  // Where tones are constant, such as in made volumes and in air, the bottom of a basin is flat.
  cells.forPairs([&](std::size_t a, std::size_t b, int, glm::ivec3) {
    if (gradient[a] != 0.0f || gradient[b] != 0.0f) return;
    const std::uint32_t one = lowestFrom(static_cast<std::uint32_t>(a), next);
    const std::uint32_t other = lowestFrom(static_cast<std::uint32_t>(b), next);
    next[std::max(one, other)] = std::min(one, other);
  });
  for (std::uint32_t cell = 0; cell < next.size(); ++cell) lowestFrom(cell, next);
  Basins basins{std::vector<std::uint32_t>(next.size()), 0};
  for (std::uint32_t cell = 0; cell < next.size(); ++cell)
    if (next[cell] == cell) basins.numbers[cell] = basins.count++;
  for (std::uint32_t cell = 0; cell < next.size(); ++cell) basins.numbers[cell] = basins.numbers[next[cell]];
  return basins;
}

}  // namespace fenestra::segmentation
