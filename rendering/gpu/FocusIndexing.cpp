#include "rendering/gpu/FocusIndexing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

#include "rendering/gpu/LabelIndex.h"
#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

/// Cells [begin, end) of a row.
struct Run {
  int begin, end;
};

/// Cells in runs along x. They are the interior ones, [0, max(dims - 2, 0)] per axis in index space; the half cells at
/// the volume's border repeat the nearest.
struct CellRuns {
  glm::ivec3 cells;
  std::vector<std::vector<Run>> rows;  ///< y fastest; the runs of a row ascend and do not touch

  explicit CellRuns(glm::ivec3 dims)
      : cells(glm::max(dims - 1, 1)), rows(static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.z)) {}
  std::size_t row(int y, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(cells.y) + static_cast<std::size_t>(y);
  }
};

/// Whether the values of any brick on a row of cells overlap `values`; the other rows need no look at their voxels.
bool rowCanMeet(int y, int z, ValueRange values, const BrickRanges& bricks) {
  const auto first = bricks.ranges.begin() + static_cast<std::ptrdiff_t>(brickOffset(
                                                 bricks.dims, {0, (y + 1) / brickSide, (z + 1) / brickSide}));
  return std::any_of(first, first + bricks.dims.x,
                     [&](const ValueRange& brick) { return brick.low <= values.high && brick.high >= values.low; });
}

constexpr std::uint8_t below = 1, within = 2, above = 4, gone = 8;

/// Classes of stored scalars against a range of real values. NaN counts as the volume's least value, ±Inf as the ends
/// of its range. Scalars of at most 16 bits are looked up.
template <class T>
class Classes {
 public:
  Classes(const Volume& volume, ValueRange values) : volume_(volume), values_(values) {
    if constexpr (isLookedUp) {
      table_.resize(std::size_t{1} << (8 * sizeof(T)));
      for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = classOf(static_cast<T>(i));
    }
  }
  std::uint8_t operator()(T scalar) const {
    if constexpr (isLookedUp)
      return table_[static_cast<std::make_unsigned_t<T>>(scalar)];
    else
      return classOf(scalar);
  }

 private:
  static constexpr bool isLookedUp = std::is_integral_v<T> && sizeof(T) <= 2;

  std::uint8_t classOf(T scalar) const {
    double real = volume_.slope * static_cast<double>(scalar) + volume_.intercept;
    if constexpr (std::is_floating_point_v<T>)
      real = std::isnan(real) ? volume_.range.low : std::clamp(real, volume_.range.low, volume_.range.high);
    return real < values_.low ? below : real > values_.high ? above : within;
  }

  const Volume& volume_;
  ValueRange values_;
  std::vector<std::uint8_t> table_;
};

/// Classes of the rows of two planes of voxels, each found when it is first asked for.
template <class T>
class ClassifiedRows {
 public:
  ClassifiedRows(const ShownVoxels& voxels, const Classes<T>& classOf, const RemovedVoxels* avoided)
      : voxels_(voxels), classOf_(classOf), avoided_(avoided), dims_(voxels.volume().grid.dims) {
    for (Plane& plane : planes_) {
      plane.classes.resize(static_cast<std::size_t>(dims_.x) * static_cast<std::size_t>(dims_.y));
      plane.zOfRow.assign(static_cast<std::size_t>(dims_.y), -1);
    }
  }

  const std::uint8_t* row(int y, int z) {
    Plane& plane = planes_[static_cast<std::size_t>(z % 2)];
    const auto at = static_cast<std::size_t>(y), width = static_cast<std::size_t>(dims_.x);
    std::uint8_t* classes = plane.classes.data() + at * width;
    if (std::exchange(plane.zOfRow[at], z) == z) return classes;
    const T* scalars = voxels_.row(y, z, buffer_);
    for (std::size_t x = 0; x < width; ++x) classes[x] = classOf_(scalars[x]);
    if (avoided_)
      avoided_->forEachIn(y, z, [&](int x, std::uint8_t coverage) {
        if (RemovedVoxels::isGone(coverage)) classes[x] |= gone;
      });
    return classes;
  }

 private:
  struct Plane {
    std::vector<std::uint8_t> classes;
    std::vector<int> zOfRow;  ///< whose row is held; -1: none
  };

  const ShownVoxels& voxels_;
  const Classes<T>& classOf_;
  const RemovedVoxels* avoided_;
  glm::ivec3 dims_;
  std::array<Plane, 2> planes_;
  std::vector<T> buffer_;
};

/// Runs of the cells whose corner values overlap the range; `classes` are those of each corner's column of four.
std::vector<Run> runsOf(const std::vector<std::uint8_t>& classes, int cells) {
  std::vector<Run> runs;
  const int last = static_cast<int>(classes.size()) - 1;
  for (int x = 0; x < cells; ++x) {
    const std::uint8_t corners =
        classes[static_cast<std::size_t>(x)] | classes[static_cast<std::size_t>(std::min(x + 1, last))];
    if (corners & gone) continue;
    // Corners below and above the range without one within: the values cross the range inside the cell.
    if (!(corners & within) && corners != (below | above)) continue;
    if (!runs.empty() && runs.back().end == x)
      ++runs.back().end;
    else
      runs.push_back({x, x + 1});
  }
  return runs;
}

/// All cells whose corner values overlap `values`, as FocusCells have them.
template <class T>
CellRuns activeCells(const ShownVoxels& voxels, const ShownVolume& shown, ValueRange values,
                     const BrickRanges& bricks) {
  const Volume& volume = voxels.volume();
  const bool avoidsGone = shown.removed && voxels.air() >= values.low && voxels.air() <= values.high;
  const glm::ivec3 dims = volume.grid.dims;
  CellRuns runs(dims);
  const Classes<T> classOf(volume, values);
  parallelFor(static_cast<std::size_t>(runs.cells.z), 1, [&](std::size_t zBegin, std::size_t zEnd) {
    std::vector<std::uint8_t> classes(static_cast<std::size_t>(dims.x));
    ClassifiedRows<T> rows(voxels, classOf, avoidsGone ? shown.removed.get() : nullptr);
    for (int z = static_cast<int>(zBegin); z < static_cast<int>(zEnd); ++z)
      for (int y = 0; y < runs.cells.y; ++y) {
        if (!rowCanMeet(y, z, values, bricks)) continue;
        const int nextY = std::min(y + 1, dims.y - 1), nextZ = std::min(z + 1, dims.z - 1);
        const std::uint8_t *a = rows.row(y, z), *b = rows.row(nextY, z);
        const std::uint8_t *c = rows.row(y, nextZ), *d = rows.row(nextY, nextZ);
        for (std::size_t x = 0; x < classes.size(); ++x)
          classes[x] = static_cast<std::uint8_t>(a[x] | b[x] | c[x] | d[x]);
        runs.rows[runs.row(y, z)] = runsOf(classes, runs.cells.x);
      }
  });
  return runs;
}

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

/// Removes the 26-connected components smaller than `leastVolume`; volumes in mm³.
void dropSmallComponents(CellRuns& runs, double cellVolume, double leastVolume) {
  std::vector<std::uint32_t> firstRun(runs.rows.size() + 1, 0);  // numbers the runs through all rows
  for (std::size_t row = 0; row < runs.rows.size(); ++row)
    firstRun[row + 1] = firstRun[row] + static_cast<std::uint32_t>(runs.rows[row].size());
  Components components(firstRun.back());
  const auto joinRows = [&](std::size_t rowA, std::size_t rowB) {
    const std::vector<Run>&a = runs.rows[rowA], &b = runs.rows[rowB];
    for (std::uint32_t i = 0, j = 0; i < a.size() && j < b.size();) {
      if (a[i].begin <= b[j].end && b[j].begin <= a[i].end)  // they overlap or touch at an edge
        components.join(firstRun[rowA] + i, firstRun[rowB] + j);
      a[i].end < b[j].end ? ++i : ++j;
    }
  };
  for (int z = 0; z < runs.cells.z; ++z)
    for (int y = 0; y < runs.cells.y; ++y) {
      if (runs.rows[runs.row(y, z)].empty()) continue;
      if (y > 0) joinRows(runs.row(y, z), runs.row(y - 1, z));
      for (int dy = -1; dy <= 1 && z > 0; ++dy)
        if (y + dy >= 0 && y + dy < runs.cells.y) joinRows(runs.row(y, z), runs.row(y + dy, z - 1));
    }

  std::vector<std::uint64_t> size(firstRun.back(), 0);
  for (std::size_t row = 0; row < runs.rows.size(); ++row)
    for (std::uint32_t i = 0; i < runs.rows[row].size(); ++i)
      size[components.find(firstRun[row] + i)] +=
          static_cast<std::uint64_t>(runs.rows[row][i].end - runs.rows[row][i].begin);
  for (std::size_t row = 0; row < runs.rows.size(); ++row) {
    std::vector<Run>& all = runs.rows[row];
    std::size_t kept = 0;
    for (std::uint32_t i = 0; i < all.size(); ++i)
      if (static_cast<double>(size[components.find(firstRun[row] + i)]) * cellVolume >= leastVolume)
        all[kept++] = all[i];
    all.resize(kept);
  }
}

/// Adds the neighbours of kept cells that are not `active` themselves, as FocusCells do for a spline.
void widen(CellRuns& kept, const CellRuns& active) {
  const CellRuns before = kept;
  std::vector<std::uint8_t> row(static_cast<std::size_t>(kept.cells.x));
  const auto mark = [&](const Run& run, int margin, std::uint8_t with) {
    std::fill(row.begin() + std::max(run.begin - margin, 0), row.begin() + std::min(run.end + margin, kept.cells.x),
              with);
  };
  for (int z = 0; z < kept.cells.z; ++z)
    for (int y = 0; y < kept.cells.y; ++y) {
      std::fill(row.begin(), row.end(), std::uint8_t{0});
      for (int nz = std::max(z - 1, 0); nz <= std::min(z + 1, kept.cells.z - 1); ++nz)
        for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, kept.cells.y - 1); ++ny)
          for (const Run& run : before.rows[before.row(ny, nz)]) mark(run, 1, 1);
      for (const Run& run : active.rows[active.row(y, z)]) mark(run, 0, 0);
      for (const Run& run : before.rows[before.row(y, z)]) mark(run, 0, 1);
      std::vector<Run>& runs = kept.rows[kept.row(y, z)];
      runs.clear();
      for (int x = 0; x < kept.cells.x; ++x) {
        if (!row[static_cast<std::size_t>(x)]) continue;
        if (!runs.empty() && runs.back().end == x)
          ++runs.back().end;
        else
          runs.push_back({x, x + 1});
      }
    }
}

/// Calls visit(begin, end, y, z) for the runs in the cell frame, [begin, end), with the half cells at the border.
template <class F>
void forEachRun(const CellRuns& runs, glm::ivec3 dims, F&& visit) {
  for (int z = 0; z <= dims.z; ++z)
    for (int y = 0; y <= dims.y; ++y)
      for (const Run& run :
           runs.rows[runs.row(std::clamp(y - 1, 0, runs.cells.y - 1), std::clamp(z - 1, 0, runs.cells.z - 1))])
        visit(run.begin == 0 ? 0 : run.begin + 1, run.end == runs.cells.x ? dims.x + 1 : run.end + 1, y, z);
}

/// Cuts each run where a brick ends: calls visit(brick's offset, begin, end, y, z) for the parts.
template <class F>
void forEachPart(const CellRuns& runs, glm::ivec3 dims, glm::ivec3 bricks, F&& visit) {
  forEachRun(runs, dims, [&](int begin, int end, int y, int z) {
    for (int x = begin; x < end;) {
      const int next = std::min(end, (x / brickSide + 1) * brickSide);
      visit(brickOffset(bricks, {x / brickSide, y / brickSide, z / brickSide}), x, next, y, z);
      x = next;
    }
  });
}

void indexCells(FocusIndex& index, const CellRuns& runs, glm::ivec3 dims) {
  std::vector<int> kept(index.slots.size(), 0);  // cells per brick
  forEachRun(runs, dims, [&](int begin, int end, int y, int z) {
    grow(index.box, glm::clamp(glm::ivec3(begin - 1, y - 1, z - 1), glm::ivec3(0), dims - 1),
         glm::clamp(glm::ivec3(end - 1, y, z), glm::ivec3(0), dims - 1));
  });
  forEachPart(runs, dims, index.bricks,
              [&](std::size_t brick, int begin, int end, int, int) { kept[brick] += end - begin; });

  constexpr std::uint32_t wordsPerBrick = cellsPerBrick / 32;
  static_assert(32 % brickSide == 0, "a brick's row of cells lies in one word");
  std::uint32_t mixed = 0;
  glm::ivec3 brick;
  for (brick.z = 0; brick.z < index.bricks.z; ++brick.z)
    for (brick.y = 0; brick.y < index.bricks.y; ++brick.y)
      for (brick.x = 0; brick.x < index.bricks.x; ++brick.x) {
        const std::size_t at = brickOffset(index.bricks, brick);
        const glm::ivec3 cells = glm::min(dims + 1 - brick * brickSide, brickSide);
        if (kept[at] > 0) index.slots[at] = kept[at] == cells.x * cells.y * cells.z ? 1 : 2 + mixed++;
      }
  index.cells.assign(static_cast<std::size_t>(mixed) * wordsPerBrick, 0);
  forEachPart(runs, dims, index.bricks, [&](std::size_t at, int begin, int end, int y, int z) {
    const std::uint32_t slot = index.slots[at];
    if (slot < 2) return;
    const std::size_t bit = cellInBrick({begin, y, z});
    index.cells[(slot - 2) * wordsPerBrick + bit / 32] |= ((1u << (end - begin)) - 1u) << (bit % 32);
  });
}

void indexValues(FocusIndex& index, const ShownVolume& shown, const ValueFocus& focus, const BrickRanges& bricks) {
  if (!(focus.values.low <= focus.values.high)) return;
  const Volume& volume = *shown.volume;
  const ShownVoxels voxels(shown);
  volume.voxels.visit([&](auto scalars) {
    CellRuns runs = activeCells<typename decltype(scalars)::value_type>(voxels, shown, focus.values, bricks);
    const CellRuns active = shown.reconstruction == Reconstruction::Linear ? CellRuns(glm::ivec3(0)) : runs;
    dropSmallComponents(runs, volume.grid.voxelVolume(), focus.minimumComponent);
    if (shown.reconstruction != Reconstruction::Linear) widen(runs, active);
    indexCells(index, runs, volume.grid.dims);
  });
}

}  // namespace

std::shared_ptr<const SmoothedIndicator> smoothedIndicator(const Scene& scene) {
  const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
  if (!focus || !scene.labels || scene.look.labelSmoothing == LabelSmoothing::Off) return nullptr;
  return std::make_shared<const SmoothedIndicator>(*scene.labels, focus->labels, scene.look.labelSmoothing);
}

FocusIndex buildFocusIndex(const Scene& scene, const BrickRanges& bricks) {
  FocusIndex index;
  index.bricks = bricks.dims;
  if (const auto* labels = std::get_if<LabelFocus>(&scene.look.focus); labels && scene.labels) {
    LabelIndexer(scene.labels).update(index, labels->labels);
    index.smoothed = smoothedIndicator(scene);
  } else if (const auto* values = std::get_if<ValueFocus>(&scene.look.focus)) {
    index.kind = FocusIndex::Kind::Values;
    index.slots.assign(bricks.ranges.size(), 0);
    indexValues(index, shownVolume(scene), *values, bricks);
  }
  return index;
}

std::optional<glm::dvec3> focusCentre(const Scene& scene) {
  if (std::holds_alternative<std::monostate>(scene.look.focus)) return std::nullopt;
  Scene exact = scene;  // smoothing takes time and does not move the box
  exact.look.labelSmoothing = LabelSmoothing::Off;
  return buildFocusIndex(exact, brickRanges(shownVolume(scene))).centre(scene.volume->grid);
}

}  // namespace fenestra
