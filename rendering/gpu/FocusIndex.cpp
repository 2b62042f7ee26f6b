#include "rendering/gpu/FocusIndex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>

#include "rendering/scene/Parallel.h"

namespace fenestra {
namespace {

// --- labels ---------------------------------------------------------------------------------------------------------

template <class T>
std::optional<IndexBox> labelledBox(std::span<const T> labels, const Grid& grid,
                                    const std::vector<std::uint8_t>& wanted) {
  std::mutex mutex;
  std::optional<IndexBox> box;
  parallelFor(static_cast<std::size_t>(grid.dims.z), 4, [&](std::size_t begin, std::size_t end) {
    std::optional<IndexBox> local;
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      for (int y = 0; y < grid.dims.y; ++y) {
        const T* row = labels.data() + grid.offset({0, y, z});
        int first = -1, last = -1;
        for (int x = 0; x < grid.dims.x; ++x)
          if (wanted[row[x]]) {
            if (first < 0) first = x;
            last = x;
          }
        if (first >= 0) grow(local, {first, y, z}, {last, y, z});
      }
    if (!local) return;
    const std::scoped_lock lock(mutex);
    grow(box, local->low, local->high);
  });
  return box;
}

template <class T>
void indexLabels(FocusIndex& index, std::span<const T> labels, const Grid& grid,
                 const std::vector<std::uint8_t>& wanted) {
  index.box = labelledBox(labels, grid, wanted);
  if (!index.box) return;
  // A voxel at index i is a corner of cells i and i + 1 in the cell frame; border half cells beyond repeat the edge.
  const glm::ivec3 firstBrick = index.box->low / brickSide;
  const glm::ivec3 lastBrick = glm::min((index.box->high + 1) / brickSide, index.bricks - 1);
  std::array<std::uint8_t, cellsPerBrick> masks{};
  constexpr int corners = brickSide + 1;
  std::array<std::uint8_t, static_cast<std::size_t>(corners * corners * corners)> inside{};
  for (int bz = firstBrick.z; bz <= lastBrick.z; ++bz)
    for (int by = firstBrick.y; by <= lastBrick.y; ++by)
      for (int bx = firstBrick.x; bx <= lastBrick.x; ++bx) {
        const glm::ivec3 base = glm::ivec3(bx, by, bz) * brickSide - 1;  // index of the brick's first corner
        bool any = false, all = true;
        for (int z = 0, at = 0; z < corners; ++z)
          for (int y = 0; y < corners; ++y)
            for (int x = 0; x < corners; ++x, ++at) {
              const glm::ivec3 voxel = glm::clamp(base + glm::ivec3(x, y, z), glm::ivec3(0), grid.dims - 1);
              const std::uint8_t in = wanted[labels[grid.offset(voxel)]];
              inside[static_cast<std::size_t>(at)] = in;
              any |= in != 0;
              all &= in != 0;
            }
        if (!any) continue;
        std::uint32_t& slot = index.slots[brickOffset(index.bricks, {bx, by, bz})];
        if (all) {
          slot = 1;
          continue;
        }
        for (int z = 0; z < brickSide; ++z)
          for (int y = 0; y < brickSide; ++y)
            for (int x = 0; x < brickSide; ++x) {
              unsigned mask = 0;
              for (int corner = 0; corner < 8; ++corner) {
                const int at =
                    (x + (corner & 1)) + corners * ((y + ((corner >> 1) & 1)) + corners * (z + (corner >> 2)));
                mask |= static_cast<unsigned>(inside[static_cast<std::size_t>(at)]) << corner;
              }
              masks[cellInBrick({x, y, z})] = static_cast<std::uint8_t>(mask);
            }
        slot = static_cast<std::uint32_t>(index.cells.size() * 4 / cellsPerBrick) + 2;
        for (std::size_t word = 0; word < cellsPerBrick / 4; ++word)
          index.cells.push_back(masks[4 * word] | masks[4 * word + 1] << 8 | masks[4 * word + 2] << 16 |
                                static_cast<std::uint32_t>(masks[4 * word + 3]) << 24);
      }
}

// --- values ---------------------------------------------------------------------------------------------------------

/// A run of active cells along x. Cells here are the interior ones, [0, max(dims-2, 0)] per axis in index space; border
/// half cells repeat the nearest.
struct Run {
  int begin, end;  // [begin, end)
};

/// Disjoint sets of runs.
class Components {
 public:
  explicit Components(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

constexpr std::uint8_t below = 1, within = 2, above = 4;

/// Classes of a row of voxels against the range, or-ed into `classes`.
template <class T>
void classifyRow(const T* row, int count, double slope, double intercept, ValueRange values, double nanValue,
                 std::uint8_t* classes) {
  for (int x = 0; x < count; ++x) {
    double real = slope * static_cast<double>(row[x]) + intercept;
    if constexpr (std::is_floating_point_v<T>)
      if (std::isnan(real)) real = nanValue;
    classes[x] |= real < values.low ? below : real > values.high ? above : within;
  }
}

template <class T>
void indexValues(FocusIndex& index, std::span<const T> scalars, const Volume& volume, const ValueFocus& focus,
                 const BrickRanges& ranges) {
  const glm::ivec3 dims = volume.grid.dims;
  const glm::ivec3 cells = glm::max(dims - 1, 1);
  const auto rowAt = [&](int y, int z) {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(cells.y) + static_cast<std::size_t>(y);
  };

  // Rows of bricks that no value of the range reaches need no look at their voxels.
  const auto rowCanMeet = [&](int y, int z) {
    const int by = (y + 1) / brickSide, bz = (z + 1) / brickSide;
    for (int bx = 0; bx < index.bricks.x; ++bx) {
      const ValueRange& r = ranges.ranges[brickOffset(index.bricks, {bx, by, bz})];
      if (r.low <= focus.values.high && r.high >= focus.values.low) return true;
    }
    return false;
  };

  std::vector<std::vector<Run>> runs(static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.z));
  parallelFor(static_cast<std::size_t>(cells.z), 1, [&](std::size_t zBegin, std::size_t zEnd) {
    std::vector<std::uint8_t> classes(static_cast<std::size_t>(dims.x));
    for (int z = static_cast<int>(zBegin); z < static_cast<int>(zEnd); ++z)
      for (int y = 0; y < cells.y; ++y) {
        if (!rowCanMeet(y, z)) continue;
        std::fill(classes.begin(), classes.end(), std::uint8_t{0});
        for (const int zz : {z, std::min(z + 1, dims.z - 1)})
          for (const int yy : {y, std::min(y + 1, dims.y - 1)})
            classifyRow(scalars.data() + volume.grid.offset({0, yy, zz}), dims.x, volume.slope, volume.intercept,
                        focus.values, volume.range.low, classes.data());
        std::vector<Run>& row = runs[rowAt(y, z)];
        for (int x = 0; x < cells.x; ++x) {
          const std::uint8_t corners =
              classes[static_cast<std::size_t>(x)] | classes[static_cast<std::size_t>(std::min(x + 1, dims.x - 1))];
          // Corners below and above without one within: the range is crossed inside the cell all the same.
          if (!(corners & within) && corners != (below | above)) continue;
          if (!row.empty() && row.back().end == x)
            ++row.back().end;
          else
            row.push_back({x, x + 1});
        }
      }
  });

  std::vector<std::uint32_t> firstRun(runs.size() + 1, 0);
  for (std::size_t row = 0; row < runs.size(); ++row)
    firstRun[row + 1] = firstRun[row] + static_cast<std::uint32_t>(runs[row].size());
  Components components(firstRun.back());
  const auto joinRows = [&](std::size_t a, std::size_t b) {
    for (std::size_t i = 0, j = 0; i < runs[a].size() && j < runs[b].size();) {
      const Run &p = runs[a][i], &q = runs[b][j];
      if (p.begin <= q.end && q.begin <= p.end)  // overlap, or touch at an edge
        components.join(firstRun[a] + static_cast<std::uint32_t>(i), firstRun[b] + static_cast<std::uint32_t>(j));
      p.end < q.end ? ++i : ++j;
    }
  };
  for (int z = 0; z < cells.z; ++z)
    for (int y = 0; y < cells.y; ++y) {
      if (runs[rowAt(y, z)].empty()) continue;
      if (y > 0) joinRows(rowAt(y, z), rowAt(y - 1, z));
      for (int dy = -1; dy <= 1 && z > 0; ++dy)
        if (y + dy >= 0 && y + dy < cells.y) joinRows(rowAt(y, z), rowAt(y + dy, z - 1));
    }
  std::vector<std::uint64_t> size(firstRun.back(), 0);
  for (std::size_t row = 0; row < runs.size(); ++row)
    for (std::size_t i = 0; i < runs[row].size(); ++i)
      size[components.find(firstRun[row] + static_cast<std::uint32_t>(i))] +=
          static_cast<std::uint64_t>(runs[row][i].end - runs[row][i].begin);
  const double voxel = volume.grid.voxelVolume();

  // Per brick: how many cells are kept; bits only where not all of them are.
  std::vector<std::uint32_t> kept(index.slots.size(), 0);
  const auto eachRun =
      [&](auto&& visit) {  // visits kept ones, (first cell-frame x, last + 1, y, z), border half cells included
        for (int z = 0; z <= dims.z; ++z)
          for (int y = 0; y <= dims.y; ++y) {
            const std::size_t row = rowAt(std::clamp(y - 1, 0, cells.y - 1), std::clamp(z - 1, 0, cells.z - 1));
            for (std::size_t i = 0; i < runs[row].size(); ++i) {
              const Run& run = runs[row][i];
              const std::uint64_t count = size[components.find(firstRun[row] + static_cast<std::uint32_t>(i))];
              if (static_cast<double>(count) * voxel >= focus.minimumComponent)
                visit(run.begin == 0 ? 0 : run.begin + 1, run.end == cells.x ? dims.x + 1 : run.end + 1, y, z);
            }
          }
      };
  // Cuts a run where one brick ends and the next begins.
  const auto eachPart = [&](auto&& visit) {  // visits (brick, first cell, last + 1, y, z)
    eachRun([&](int begin, int end, int y, int z) {
      for (int x = begin; x < end;) {
        const int next = std::min(end, (x / brickSide + 1) * brickSide);
        visit(brickOffset(index.bricks, {x / brickSide, y / brickSide, z / brickSide}), x, next, y, z);
        x = next;
      }
    });
  };
  eachRun([&](int begin, int end, int y, int z) {
    grow(index.box, glm::clamp(glm::ivec3(begin - 1, y - 1, z - 1), glm::ivec3(0), dims - 1),
         glm::clamp(glm::ivec3(end - 1, y, z), glm::ivec3(0), dims - 1));
  });
  eachPart(
      [&](std::size_t brick, int begin, int end, int, int) { kept[brick] += static_cast<std::uint32_t>(end - begin); });
  constexpr std::uint32_t wordsPerBrick = cellsPerBrick / 32;
  std::uint32_t mixed = 0;
  for (int z = 0; z < index.bricks.z; ++z)
    for (int y = 0; y < index.bricks.y; ++y)
      for (int x = 0; x < index.bricks.x; ++x) {
        const std::size_t brick = brickOffset(index.bricks, {x, y, z});
        const glm::ivec3 all = glm::min(dims + 1 - glm::ivec3(x, y, z) * brickSide, brickSide);
        if (kept[brick] > 0)
          index.slots[brick] = kept[brick] == static_cast<std::uint32_t>(all.x * all.y * all.z) ? 1 : 2 + mixed++;
      }
  index.cells.assign(static_cast<std::size_t>(mixed) * wordsPerBrick, 0);
  eachPart([&](std::size_t brick, int begin, int end, int y, int z) {
    const std::uint32_t slot = index.slots[brick];
    if (slot < 2) return;
    const std::size_t bit = cellInBrick({begin, y, z});
    index.cells[(slot - 2) * wordsPerBrick + bit / 32] |= ((1u << (end - begin)) - 1u) << (bit % 32);
  });
}

}  // namespace

FocusIndex buildFocusIndex(const Scene& scene, const BrickRanges& ranges) {
  FocusIndex index;
  index.bricks = ranges.dims;
  if (const auto* labels = std::get_if<LabelFocus>(&scene.look.focus); labels && scene.labels) {
    index.kind = FocusIndex::Kind::Labels;
    index.slots.assign(ranges.ranges.size(), 0);
    std::vector<std::uint8_t> wanted(std::numeric_limits<std::uint16_t>::max() + 1, 0);
    for (const std::uint16_t label : labels->labels) wanted[label] = 1;
    if (scene.labels->voxels.type() == ScalarType::UInt8)
      indexLabels(index, scene.labels->voxels.as<std::uint8_t>(), scene.labels->grid, wanted);
    else
      indexLabels(index, scene.labels->voxels.as<std::uint16_t>(), scene.labels->grid, wanted);
  } else if (const auto* values = std::get_if<ValueFocus>(&scene.look.focus)) {
    index.kind = FocusIndex::Kind::Values;
    index.slots.assign(ranges.ranges.size(), 0);
    scene.volume->voxels.visit([&](auto scalars) { indexValues(index, scalars, *scene.volume, *values, ranges); });
  }
  return index;
}

}  // namespace fenestra
