#include "rendering/gpu/LabelIndex.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <limits>
#include <utility>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

constexpr int cornerSide = brickSide + 1;  ///< voxels at the corners of a brick's cells, along each axis
constexpr std::size_t labelCount = std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1;

/// Calls visit(std::span of the labels' type); the voxels are UInt8 or UInt16.
template <class Visit>
decltype(auto) withLabels(const LabelMap& map, Visit&& visit) {
  if (map.voxels.type() == ScalarType::UInt8) return visit(map.voxels.as<std::uint8_t>());
  return visit(map.voxels.as<std::uint16_t>());
}

/// Entry i: in byte x, the bits x and x + 1 of i, for all cells along a row of corners.
constexpr std::array<std::uint32_t, 1 << cornerSide> cornerPairs() {
  std::array<std::uint32_t, 1 << cornerSide> pairs{};
  for (std::uint32_t row = 0; row < pairs.size(); ++row)
    for (std::uint32_t x = 0; x < brickSide; ++x) pairs[row] |= (row >> x & 3u) << (8 * x);
  return pairs;
}

/// Which voxels at the corners of a brick's cells have a label of the focus; corners beyond the volume repeat its edge.
class BrickCorners {
 public:
  template <class T>
  BrickCorners(glm::ivec3 brick, std::span<const T> labels, const Grid& grid, const std::vector<std::uint8_t>& wanted)
      : first_(brick * brickSide - 1), last_(grid.dims - 1) {
    std::array<std::ptrdiff_t, cornerSide> columns{};
    for (int x = 0; x < cornerSide; ++x) columns[static_cast<std::size_t>(x)] = std::clamp(first_.x + x, 0, last_.x);
    const std::uint8_t* inFocus = wanted.data();
    for (int z = 0, at = 0; z < cornerSide; ++z)
      for (int y = 0; y < cornerSide; ++y, ++at) {
        const T* row =
            labels.data() + rowOffset(grid, std::clamp(first_.y + y, 0, last_.y), std::clamp(first_.z + z, 0, last_.z));
        std::uint32_t bits = 0;
        for (std::size_t x = 0; x < columns.size(); ++x) bits |= std::uint32_t{inFocus[row[columns[x]]]} << x;
        rows_[static_cast<std::size_t>(at)] = bits;
        any_ |= bits;
        all_ &= bits;
      }
  }
  bool any() const { return any_ != 0; }
  bool all() const { return all_ == (1u << cornerSide) - 1u; }
  /// The cells (0…3, y, z), a byte each: bit i is corner i, x fastest.
  std::uint32_t cells(int y, int z) const {
    static constexpr std::array<std::uint32_t, 1 << cornerSide> pairs = cornerPairs();
    return pairs[row(y, z)] | pairs[row(y + 1, z)] << 2 | pairs[row(y, z + 1)] << 4 | pairs[row(y + 1, z + 1)] << 6;
  }
  /// Makes `box` hold the voxels of the focus.
  void addTo(std::optional<IndexBox>& box) const {
    for (int z = 0; z < cornerSide; ++z)
      for (int y = 0; y < cornerSide; ++y) {
        if (row(y, z) == 0) continue;
        const int left = std::countr_zero(row(y, z)), right = std::bit_width(row(y, z)) - 1;
        grow(box, glm::clamp(first_ + glm::ivec3(left, y, z), glm::ivec3(0), last_),
             glm::clamp(first_ + glm::ivec3(right, y, z), glm::ivec3(0), last_));
      }
  }
  /// Where a row of voxels begins.
  static std::size_t rowOffset(const Grid& grid, int y, int z) {
    return static_cast<std::size_t>(grid.dims.x) *
           (static_cast<std::size_t>(y) + static_cast<std::size_t>(grid.dims.y) * static_cast<std::size_t>(z));
  }

 private:
  std::uint32_t row(int y, int z) const { return rows_[static_cast<std::size_t>(y + cornerSide * z)]; }

  glm::ivec3 first_, last_;  ///< indices of the brick's first corner, and of the volume's last voxel
  std::array<std::uint32_t, static_cast<std::size_t>(cornerSide* cornerSide)> rows_{};  ///< bit x is a voxel
  std::uint32_t any_ = 0, all_ = ~0u;
};

/// Starts to fetch a brick's labels from memory: its rows lie far apart, and there are many bricks.
template <class T>
void prefetch(glm::ivec3 brick, std::span<const T> labels, const Grid& grid) {
  const glm::ivec3 first = brick * brickSide - 1, last = grid.dims - 1;
  const int x = std::clamp(first.x, 0, last.x);
  for (int z = 0; z < cornerSide; ++z)
    for (int y = 0; y < cornerSide; ++y)
      __builtin_prefetch(
          labels.data() + x +
          BrickCorners::rowOffset(grid, std::clamp(first.y + y, 0, last.y), std::clamp(first.z + z, 0, last.z)));
}

/// Entry i: how many labels below i satisfy the condition.
template <class Holds>
std::vector<std::uint32_t> countsUpTo(Holds holds) {
  std::vector<std::uint32_t> counts(labelCount + 1, 0);
  for (std::size_t label = 0; label < labelCount; ++label) counts[label + 1] = counts[label] + (holds(label) ? 1u : 0u);
  return counts;
}

}  // namespace

LabelIndexer::LabelIndexer(std::shared_ptr<const LabelMap> map)
    : map_(std::move(map)), bricks_(brickCount(map_->grid.dims)), wanted_(labelCount, 0) {
  ranges_.resize(brickOffset(bricks_, {0, 0, bricks_.z}));
  withLabels(*map_, [this](auto labels) { readRanges(labels); });
}

template <class T>
void LabelIndexer::readRanges(std::span<const T> labels) {
  const Grid& grid = map_->grid;
  const auto width = static_cast<std::size_t>(grid.dims.x);
  parallelFor(static_cast<std::size_t>(bricks_.z) * static_cast<std::size_t>(bricks_.y), 64,
              [&](std::size_t begin, std::size_t end) {
                // Least label less one, where 0 wraps to the greatest number, and greatest label of each column of
                // voxels.
                std::vector<T> least(width), greatest(width);
                for (std::size_t row = begin; row < end; ++row) {
                  const glm::ivec3 first =
                      glm::ivec3(0, static_cast<int>(row) % bricks_.y, static_cast<int>(row) / bricks_.y);
                  std::fill(least.begin(), least.end(), std::numeric_limits<T>::max());
                  std::fill(greatest.begin(), greatest.end(), T{0});
                  const glm::ivec3 low = glm::max(first * brickSide - 1, 0);
                  const glm::ivec3 high = glm::min(first * brickSide + brickSide - 1, grid.dims - 1);
                  for (int z = std::min(low.z, high.z); z <= high.z; ++z)
                    for (int y = std::min(low.y, high.y); y <= high.y; ++y) {
                      const T* voxels = labels.data() + grid.offset({0, y, z});
                      for (std::size_t x = 0; x < width; ++x) {
                        least[x] = std::min(least[x], static_cast<T>(voxels[x] - 1));
                        greatest[x] = std::max(greatest[x], voxels[x]);
                      }
                    }
                  for (int brick = 0; brick < bricks_.x; ++brick) {
                    Range& range = ranges_[row * static_cast<std::size_t>(bricks_.x) + static_cast<std::size_t>(brick)];
                    const int last = std::min(brick * brickSide + brickSide - 1, grid.dims.x - 1);
                    for (int x = std::min(std::max(brick * brickSide - 1, 0), last); x <= last; ++x) {
                      const auto column = static_cast<std::size_t>(x);
                      if (greatest[column] == 0) continue;
                      range.least = std::min(range.least, static_cast<std::uint16_t>(least[column] + 1));
                      range.greatest = std::max(range.greatest, static_cast<std::uint16_t>(greatest[column]));
                    }
                  }
                }
              });
}

glm::ivec3 LabelIndexer::brickAt(std::size_t offset) const {
  const auto x = static_cast<std::size_t>(bricks_.x), y = static_cast<std::size_t>(bricks_.y);
  return {offset % x, offset / x % y, offset / (x * y)};
}

template <class T>
LabelIndexer::Found LabelIndexer::lookAt(glm::ivec3 brick, std::span<const T> labels) const {
  const BrickCorners corners(brick, labels, map_->grid, wanted_);
  Found found{.brick = brickOffset(bricks_, brick), .kind = corners.all() ? 1u : corners.any() ? 2u : 0u};
  if (found.kind < 2) return found;
  static_assert(brickSide == 4, "a word holds a row of cells");
  for (int z = 0, word = 0; z < brickSide; ++z)
    for (int y = 0; y < brickSide; ++y, ++word) found.cells[static_cast<std::size_t>(word)] = corners.cells(y, z);
  return found;
}

std::vector<std::size_t> LabelIndexer::concernedBricks(const std::vector<std::uint32_t>& changedUpTo) const {
  const bool background = changedUpTo[1] != 0;  // label 0, which no range holds
  const std::size_t layer = brickOffset(bricks_, {0, 0, 1});
  std::vector<std::vector<std::size_t>> layers(static_cast<std::size_t>(bricks_.z));
  parallelFor(layers.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t z = begin; z < end; ++z)
      for (std::size_t brick = z * layer; brick < (z + 1) * layer; ++brick) {
        const Range range = ranges_[brick];
        const bool concerned =
            range.least <= range.greatest && changedUpTo[range.greatest + 1u] != changedUpTo[range.least];
        if (concerned || background) layers[z].push_back(brick);
      }
  });
  std::vector<std::size_t> bricks;
  for (const std::vector<std::size_t>& each : layers) bricks.insert(bricks.end(), each.begin(), each.end());
  return bricks;
}

std::vector<LabelIndexer::Found> LabelIndexer::changedBricks(const FocusIndex& index,
                                                             const std::vector<std::size_t>& concerned) const {
  const auto differs = [&](const Found& found) {
    const std::uint32_t slot = index.slots[found.brick];
    if (found.kind != std::min(slot, 2u)) return true;
    return slot >= 2 && !std::equal(found.cells.begin(), found.cells.end(),
                                    index.cells.begin() + static_cast<std::ptrdiff_t>((slot - 2) * wordsPerBrick));
  };
  constexpr std::size_t ahead = 6;  // bricks: long enough for memory to answer
  constexpr std::size_t piece = 256;
  std::vector<std::vector<Found>> pieces((concerned.size() + piece - 1) / piece);
  withLabels(*map_, [&](auto labels) {
    parallelFor(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
      const std::size_t last = std::min(end * piece, concerned.size());
      for (std::size_t i = begin * piece; i < last; ++i) {
        if (i + ahead < last) prefetch(brickAt(concerned[i + ahead]), labels, map_->grid);
        const Found found = lookAt(brickAt(concerned[i]), labels);
        if (differs(found)) pieces[i / piece].push_back(found);
      }
    });
  });
  std::vector<Found> all;
  for (const std::vector<Found>& each : pieces) all.insert(all.end(), each.begin(), each.end());
  return all;
}

void LabelIndexer::apply(FocusIndex& index, const std::vector<Found>& found, Change& change) {
  // Slots that fall free, and bricks that have none yet.
  std::vector<std::uint32_t> free;
  std::vector<const Found*> wanting;
  const auto put = [&](std::uint32_t slot, const Found& of) {
    std::copy(of.cells.begin(), of.cells.end(),
              index.cells.begin() + static_cast<std::ptrdiff_t>((slot - 2) * wordsPerBrick));
    index.slots[of.brick] = slot;
    owners_[slot - 2] = of.brick;
  };
  std::vector<std::size_t> touched;
  for (const Found& each : found) {
    const std::uint32_t before = index.slots[each.brick];
    change.bricks.push_back(each.brick);
    if (before == 0) change.filled.push_back(each.brick);
    if (each.kind == 0) change.emptied.push_back(each.brick);
    if (before >= 2 && each.kind == 2) {
      put(before, each);
      continue;
    }
    touched.push_back(each.brick);
    if (before >= 2) free.push_back(before);
    if (each.kind == 2)
      wanting.push_back(&each);
    else
      index.slots[each.brick] = each.kind;
  }
  for (const Found* each : wanting) {
    if (free.empty()) {
      free.push_back(static_cast<std::uint32_t>(owners_.size()) + 2);
      owners_.emplace_back();
      index.cells.resize(index.cells.size() + wordsPerBrick);
    }
    put(free.back(), *each);
    free.pop_back();
  }
  // The last slots move into those that are still free, so that there is one for each brick that is cut and no other.
  std::sort(free.rbegin(), free.rend());
  for (const std::uint32_t slot : free) {
    const std::size_t last = owners_.size() - 1;
    if (slot - 2 != last) {
      std::copy_n(index.cells.begin() + static_cast<std::ptrdiff_t>(last * wordsPerBrick), wordsPerBrick,
                  index.cells.begin() + static_cast<std::ptrdiff_t>((slot - 2) * wordsPerBrick));
      owners_[slot - 2] = owners_[last];
      index.slots[owners_[last]] = slot;
      touched.push_back(owners_[last]);
    }
    owners_.pop_back();
    index.cells.resize(index.cells.size() - wordsPerBrick);
  }
  if (touched.empty()) return;
  const auto [first, last] = std::minmax_element(touched.begin(), touched.end());
  const std::size_t layer = brickOffset(bricks_, {0, 0, 1});
  change.firstLayer = static_cast<int>(*first / layer);
  change.lastLayer = static_cast<int>(*last / layer);
}

std::optional<IndexBox> LabelIndexer::boxOf(const FocusIndex& index) const {
  std::vector<std::optional<IndexBox>> layers(static_cast<std::size_t>(bricks_.z));
  parallelFor(layers.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t z = begin; z < end; ++z)
      for (int y = 0; y < bricks_.y; ++y) {
        const auto row = index.slots.begin() + static_cast<std::ptrdiff_t>(brickOffset(bricks_, {0, y, z}));
        const auto holds = [](std::uint32_t slot) { return slot != 0; };
        const auto first = std::find_if(row, row + bricks_.x, holds);
        if (first == row + bricks_.x) continue;
        const auto last = std::find_if(std::reverse_iterator(row + bricks_.x), std::reverse_iterator(row), holds);
        grow(layers[z], {first - row, y, z}, {last.base() - row - 1, y, z});
      }
  });
  std::optional<IndexBox> bricks, box;
  for (const std::optional<IndexBox>& layer : layers)
    if (layer) grow(bricks, layer->low, layer->high);
  if (!bricks) return box;
  // The outermost voxels lie in the outermost bricks.
  withLabels(*map_, [&](auto labels) {
    glm::ivec3 brick;
    for (brick.z = bricks->low.z; brick.z <= bricks->high.z; ++brick.z)
      for (brick.y = bricks->low.y; brick.y <= bricks->high.y; ++brick.y) {
        const bool isOutside = brick.z == bricks->low.z || brick.z == bricks->high.z || brick.y == bricks->low.y ||
                               brick.y == bricks->high.y;
        const int step = isOutside ? 1 : std::max(1, bricks->high.x - bricks->low.x);
        for (brick.x = bricks->low.x; brick.x <= bricks->high.x; brick.x += step)
          if (index.slots[brickOffset(bricks_, brick)] != 0)
            BrickCorners(brick, labels, map_->grid, wanted_).addTo(box);
      }
  });
  return box;
}

LabelIndexer::Change LabelIndexer::update(FocusIndex& index, const std::vector<std::uint16_t>& labels) {
  std::vector<std::uint8_t> wanted(labelCount, 0);
  for (const std::uint16_t label : labels) wanted[label] = 1;
  const std::vector<std::uint8_t> before = std::exchange(wanted_, std::move(wanted));
  if (index.slots.empty()) {
    index.kind = FocusIndex::Kind::Labels;
    index.bricks = bricks_;
    index.slots.assign(ranges_.size(), 0);
  }
  Change change;
  const auto changedUpTo = countsUpTo([&](std::size_t label) { return wanted_[label] != before[label]; });
  apply(index, changedBricks(index, concernedBricks(changedUpTo)), change);
  if (!change.bricks.empty()) index.box = boxOf(index);
  return change;
}

}  // namespace fenestra
