#include "rendering/scene/SmoothedIndicator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

constexpr int side = TileMap::side;
constexpr int level = 32768;  ///< from here on a voxel is inside
/// Least difference of a value from the level, in 65535ths: less would leave a surface that all but touches a voxel's
/// centre.
constexpr int margin = 512;

constexpr float leastChange = 0.25f;  ///< of a cell's part; a flat surface's is 2 and more

constexpr std::size_t cubed(int n) {
  return static_cast<std::size_t>(n) * static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
}

/// A value moved to where the condition holds; `inside`: the voxel has one of the labels.
std::uint16_t held(int value, bool inside) {
  return static_cast<std::uint16_t>(inside ? std::clamp<int>(value, level + margin, SmoothedIndicator::one)
                                           : std::clamp(value, 0, level - 1 - margin));
}

/// The part of a cell that is inside.
struct CellPart {
  float volume = 0.0f;  ///< share of the cell
  float change = 0.0f;  ///< of that share with values greater by 1, to first order
};

/// Places and weights of a Gauss-Legendre rule on [0, 1]. Their number is even, so that no place is halfway between two
/// voxels, where the 0/1 indicator's level often is.
template <std::size_t points>
struct Rule {
  std::array<float, points> places, weights;
};
constexpr Rule<4> coarse{{0.06943184f, 0.33000948f, 0.66999052f, 0.93056816f},
                         {0.17392742f, 0.32607258f, 0.32607258f, 0.17392742f}};
constexpr Rule<10> fine{{0.01304674f, 0.06746832f, 0.16029522f, 0.28330230f, 0.42556283f, 0.57443717f, 0.71669770f,
                         0.83970478f, 0.93253168f, 0.98695326f},
                        {0.03333567f, 0.07472567f, 0.10954318f, 0.13463336f, 0.14776211f, 0.14776211f, 0.13463336f,
                         0.10954318f, 0.07472567f, 0.03333567f}};

/// `f`: a cell's corners above the level, x fastest; trilinear between them. Along the axis of the steepest change the
/// share of each line is exact; across it, the rule is taken on either axis.
template <std::size_t points>
CellPart partInside(const std::array<float, 8>& f, const Rule<points>& rule) {
  std::array<float, 3> slopes{};
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) slopes[axis] += (i >> axis & 1u) ? f[i] : -f[i];
  for (float& slope : slopes) slope = std::abs(slope);
  const std::size_t along = slopes[0] >= slopes[1] && slopes[0] >= slopes[2] ? 0 : slopes[1] >= slopes[2] ? 1 : 2;
  const std::size_t a = 1u << ((along + 1) % 3), b = 1u << ((along + 2) % 3), step = 1u << along;

  CellPart part;
  for (std::size_t j = 0; j < points; ++j) {
    const auto between = [&](std::size_t corner) { return f[corner] + rule.places[j] * (f[corner + b] - f[corner]); };
    const float low0 = between(0), low1 = between(a), high0 = between(step), high1 = between(step + a);
    for (std::size_t i = 0; i < points; ++i) {
      const float low = low0 + rule.places[i] * (low1 - low0), high = high0 + rule.places[i] * (high1 - high0);
      const float weight = rule.weights[i] * rule.weights[j];
      if ((low >= 0.0f) == (high >= 0.0f)) {
        part.volume += low >= 0.0f ? weight : 0.0f;
        continue;
      }
      const float change = weight / std::abs(high - low);
      part.volume += change * std::max(low, high);
      part.change += change;
    }
  }
  // A corner that the rule misses must count, too: without a change, no shift of the values would bring it back.
  part.change = std::max(part.change, leastChange);
  return part;
}

/// Volumes of the 0/1 indicator's cells, by their corners inside. The smoothed cells that are compared with them must
/// use the same rule: its errors are then alike where the shapes are.
template <std::size_t points>
const std::array<float, 256>& volumesOfCells(const Rule<points>& rule) {
  static const std::array<float, 256> volumes = [&] {
    std::array<float, 256> all{};
    for (std::size_t corners = 0; corners < all.size(); ++corners) {
      std::array<float, 8> f{};
      for (std::size_t i = 0; i < f.size(); ++i) f[i] = (corners >> i & 1u) ? 0.5f : -0.5f;
      all[corners] = partInside(f, rule).volume;
    }
    return all;
  }();
  return volumes;
}

class Smoothing {
 public:
  Smoothing(TileMap& tiles, std::vector<std::uint16_t>& values) : tiles_(tiles), values_(values) {}

  /// The 0/1 indicator, in tiles near its surface.
  template <class T>
  void begin(const LabelMap& map, std::span<const T> labels, std::span<const std::uint16_t> inFocus);
  /// One step of diffusion, a Gaussian of σ = 1 voxel, under the condition.
  void diffuse();
  /// Finds by blocks of cells how much more than the 0/1 indicator's surface the surface encloses.
  template <std::size_t points>
  void measure(const Rule<points>& rule);
  /// Measures as exactly as a thin structure needs; in a large surface's many cells, errors cancel.
  void measureWell() {
    constexpr std::size_t large = 4096;  // tiles
    cut_ < large ? measure(fine) : measure(coarse);
  }
  /// Shifts values so that the volume around them is right, by Newton's method on what measure() has found.
  void shiftNear();
  /// Shifts all values by one amount so that the whole volume is right; returns whether it was.
  bool shiftAll();

 private:
  /// Sets each tile's slot: 0 or 1 where its voxels are alike, else `mixed`.
  template <class T>
  void findTiles(std::span<const T> labels);
  /// Lists the tiles that are mixed or touch a tile that differs from them.
  void findActive();
  /// Calls work(number, first voxel) for the tiles with the numbers below `count`.
  template <class Work>
  void forTiles(std::size_t count, Work&& work) {
    parallelFor(count, 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        interruptionPoint();
        work(i, active_[i] * side);
      }
    });
  }

  static constexpr std::uint32_t mixed = 2;
  // Cells are counted in blocks, of which a tile has two along each axis.
  static constexpr int blockSide = 4, blocksPerSide = side / blockSide;
  static constexpr std::size_t blocks = cubed(blocksPerSide);

  TileMap& tiles_;
  std::vector<std::uint16_t>& values_;
  std::vector<std::uint16_t> next_;
  std::vector<std::uint8_t> wanted_;  ///< by label
  std::vector<glm::ivec3> active_;    ///< tiles with values of their own; those with a cell that is cut come first
  std::size_t cut_ = 0;               ///< number of those
  /// Sums over the blocks of those tiles, where a cell counts in the block of its last corner: by how many cells more
  /// is inside than with the 0/1 indicator, and how many more would be with values greater by 1.
  std::vector<glm::vec2> parts_;
  std::vector<float> volumes_;  ///< inside the 0/1 indicator's surface
};

template <class T>
void Smoothing::findTiles(std::span<const T> labels) {
  parallelFor(tiles_.slots.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto x = static_cast<std::size_t>(tiles_.count.x), y = static_cast<std::size_t>(tiles_.count.y);
      const glm::ivec3 low = glm::ivec3(i % x, i / x % y, i / (x * y)) * side, high = glm::min(low + side, tiles_.dims);
      std::uint8_t any = 0, all = 1;
      for (int z = low.z; z < high.z; ++z)
        for (int row = low.y; row < high.y; ++row) {
          const std::size_t at =
              static_cast<std::size_t>(tiles_.dims.x) *
              (static_cast<std::size_t>(row) + static_cast<std::size_t>(tiles_.dims.y) * static_cast<std::size_t>(z));
          for (int column = low.x; column < high.x; ++column) {
            const std::uint8_t inside = wanted_[labels[at + static_cast<std::size_t>(column)]];
            any |= inside;
            all &= inside;
          }
        }
      tiles_.slots[i] = any == 0 ? 0 : all ? 1 : mixed;
    }
  });
}

void Smoothing::findActive() {
  // In all others values stay 0 or 1. These are a tile or more from the surface: about three times the σ of all steps.
  std::vector<std::uint32_t> slots(tiles_.slots);
  glm::ivec3 tile, near;
  for (tile.z = 0; tile.z < tiles_.count.z; ++tile.z)
    for (tile.y = 0; tile.y < tiles_.count.y; ++tile.y)
      for (tile.x = 0; tile.x < tiles_.count.x; ++tile.x) {
        const std::uint32_t own = tiles_.slots[tiles_.offset(tile)];
        const glm::ivec3 low = glm::max(tile - 1, 0), high = glm::min(tile + 1, tiles_.count - 1);
        bool isAlike = own != mixed;
        for (near.z = low.z; near.z <= high.z; ++near.z)
          for (near.y = low.y; near.y <= high.y; ++near.y)
            for (near.x = low.x; near.x <= high.x; ++near.x) isAlike &= tiles_.slots[tiles_.offset(near)] == own;
        if (isAlike) continue;
        active_.push_back(tile);
        slots[tiles_.offset(tile)] = mixed;
      }
  tiles_.slots = std::move(slots);
}

template <class T>
void Smoothing::begin(const LabelMap& map, std::span<const T> labels, std::span<const std::uint16_t> inFocus) {
  wanted_.assign(std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1, 0);
  for (const std::uint16_t label : inFocus) wanted_[label] = 1;
  tiles_.dims = map.grid.dims;
  tiles_.count = (map.grid.dims + side - 1) / side;
  tiles_.slots.assign(tiles_.offset({0, 0, tiles_.count.z}), 0);
  findTiles(labels);
  findActive();

  const auto insideAt = [&](glm::ivec3 voxel) {
    return wanted_[labels[map.grid.offset(glm::clamp(voxel, glm::ivec3(0), tiles_.dims - 1))]] != 0;
  };
  std::vector<std::uint8_t> isCut(active_.size(), 0);
  forTiles(active_.size(), [&](std::size_t i, glm::ivec3 low) {
    const bool first = insideAt(low);
    glm::ivec3 at;
    for (at.z = -1; at.z < side && !isCut[i]; ++at.z)
      for (at.y = -1; at.y < side && !isCut[i]; ++at.y)
        for (at.x = -1; at.x < side && !isCut[i]; ++at.x) isCut[i] = insideAt(low + at) != first;
  });
  std::vector<glm::ivec3> ordered;
  for (const std::uint8_t cut : {1, 0}) {
    for (std::size_t i = 0; i < active_.size(); ++i)
      if (isCut[i] == cut) ordered.push_back(active_[i]);
    if (cut) cut_ = ordered.size();
  }
  active_ = std::move(ordered);
  for (std::size_t i = 0; i < active_.size(); ++i)
    tiles_.slots[tiles_.offset(active_[i])] = 2 + static_cast<std::uint32_t>(i);

  values_.resize(active_.size() * TileMap::voxels);
  next_.resize(values_.size());
  parts_.resize(cut_ * blocks);
  volumes_.resize(parts_.size());
  forTiles(active_.size(), [&](std::size_t i, glm::ivec3 low) {
    std::uint16_t* to = values_.data() + i * TileMap::voxels;
    glm::ivec3 at;
    for (at.z = 0; at.z < side; ++at.z)
      for (at.y = 0; at.y < side; ++at.y)
        for (at.x = 0; at.x < side; ++at.x) *to++ = insideAt(low + at) ? SmoothedIndicator::one : 0;
  });
}

void Smoothing::diffuse() {
  constexpr int taps = 4, wide = side + taps;  // (1 4 6 4 1)/16 along each axis
  forTiles(active_.size(), [&](std::size_t tile, glm::ivec3 low) {
    std::array<std::uint16_t, cubed(wide)> block;
    tiles_.read<side, std::uint16_t>(values_, {0, SmoothedIndicator::one}, low - taps / 2, glm::ivec3(wide),
                                     block.data());
    const auto sum = [](const auto* from, std::size_t step) {
      return std::uint32_t{from[0]} + from[4 * step] + 4u * (std::uint32_t{from[step]} + from[3 * step]) +
             6u * from[2 * step];
    };
    constexpr std::size_t s = side, w = wide;
    std::array<std::uint32_t, s * w * w> alongX;
    for (std::size_t row = 0; row < w * w; ++row)
      for (std::size_t x = 0; x < s; ++x) alongX[row * s + x] = sum(block.data() + row * w + x, 1);
    std::array<std::uint32_t, s * s * w> alongY;
    for (std::size_t z = 0; z < w; ++z)
      for (std::size_t at = 0; at < s * s; ++at) alongY[z * s * s + at] = sum(alongX.data() + z * s * w + at, s);
    std::uint16_t* to = next_.data() + tile * TileMap::voxels;
    const std::uint16_t* from = values_.data() + tile * TileMap::voxels;
    for (std::size_t at = 0; at < TileMap::voxels; ++at) {
      constexpr std::uint32_t unit = 16 * 16 * 16;
      to[at] = held(static_cast<int>((sum(alongY.data() + at, s * s) + unit / 2) / unit), from[at] >= level);
    }
  });
  values_.swap(next_);
}

template <std::size_t points>
void Smoothing::measure(const Rule<points>& rule) {
  constexpr int wide = side + 1;
  const std::array<float, 256>& before = volumesOfCells(rule);
  forTiles(cut_, [&](std::size_t tile, glm::ivec3 low) {
    std::array<std::uint16_t, cubed(wide)> block;
    tiles_.read<side, std::uint16_t>(values_, {0, SmoothedIndicator::one}, low - 1, glm::ivec3(wide), block.data());
    std::fill_n(parts_.begin() + static_cast<std::ptrdiff_t>(tile * blocks), blocks, glm::vec2(0.0f));
    std::fill_n(volumes_.begin() + static_cast<std::ptrdiff_t>(tile * blocks), blocks, 0.0f);
    const glm::ivec3 size = glm::min(tiles_.dims - low, side);
    glm::ivec3 at;
    for (at.z = 0; at.z < size.z; ++at.z)
      for (at.y = 0; at.y < size.y; ++at.y)
        for (at.x = 0; at.x < size.x; ++at.x) {
          std::array<float, 8> f;
          std::size_t inside = 0;
          for (std::size_t i = 0; i < 8; ++i) {
            const glm::ivec3 corner = at + glm::ivec3(i & 1u, i >> 1 & 1u, i >> 2);
            const int value = block[static_cast<std::size_t>(corner.x + wide * (corner.y + wide * corner.z))];
            f[i] = static_cast<float>(value) * (1.0f / SmoothedIndicator::one) - 0.5f;
            inside |= static_cast<std::size_t>(value >= level) << i;
          }
          if (inside == 0) continue;
          const glm::ivec3 index = low + at, in = at / blockSide;
          const std::size_t sum =
              tile * blocks + static_cast<std::size_t>(in.x + blocksPerSide * (in.y + blocksPerSide * in.z));
          // Cells at the volume's border are half as wide.
          const float width = (index.x ? 1.0f : 0.5f) * (index.y ? 1.0f : 0.5f) * (index.z ? 1.0f : 0.5f);
          volumes_[sum] += width * before[inside];
          if (inside == 255) continue;
          const CellPart part = partInside(f, rule);
          parts_[sum] += width * glm::vec2(part.volume - before[inside], part.change);
        }
  });
}

void Smoothing::shiftNear() {
  // Around each block (1 4 6 4 1) along each axis, a Gaussian of σ = 4 voxels; trilinear between the blocks' centres,
  // which lie at the voxels 4 k + 1.
  constexpr int near = blocksPerSide + 2, taps = 4, wide = near + taps;
  constexpr float most = 0.1f;  // where next to nothing would change the volume
  constexpr std::size_t n = near, w = wide;
  const auto sumsAround = [this](glm::ivec3 low) {
    std::array<glm::vec2, w * w * w> block;
    tiles_.read<blocksPerSide, glm::vec2>(parts_, {glm::vec2(0.0f), glm::vec2(0.0f)}, low / blockSide - 1 - taps / 2,
                                          glm::ivec3(wide), block.data());
    const auto sum = [](const glm::vec2* from, std::size_t step) {
      return from[0] + from[4 * step] + 4.0f * (from[step] + from[3 * step]) + 6.0f * from[2 * step];
    };
    std::array<glm::vec2, n * w * w> alongX;
    for (std::size_t row = 0; row < w * w; ++row)
      for (std::size_t x = 0; x < n; ++x) alongX[row * n + x] = sum(block.data() + row * w + x, 1);
    std::array<glm::vec2, n * n * w> alongY;
    for (std::size_t z = 0; z < w; ++z)
      for (std::size_t at = 0; at < n * n; ++at) alongY[z * n * n + at] = sum(alongX.data() + z * n * w + at, n);
    std::array<glm::vec2, n * n * n> sums;
    for (std::size_t at = 0; at < sums.size(); ++at) sums[at] = sum(alongY.data() + at, n * n);
    return sums;
  };
  // A place along an axis lies between two blocks: the number of the one before it, and the share of the one behind it.
  const auto blockBefore = [](int at) { return static_cast<std::size_t>((at + blockSide - 1) / blockSide); };
  const auto shareBehind = [](int at) { return static_cast<float>((at + blockSide - 1) % blockSide) / blockSide; };
  forTiles(active_.size(), [&](std::size_t tile, glm::ivec3 low) {
    const std::array<glm::vec2, n* n* n> sums = sumsAround(low);
    if (std::all_of(sums.begin(), sums.end(), [](glm::vec2 each) { return each.y == 0.0f; })) return;
    std::uint16_t* value = values_.data() + tile * TileMap::voxels;
    for (int z = 0; z < side; ++z)
      for (int y = 0; y < side; ++y) {
        std::array<glm::vec2, n> row;
        for (std::size_t x = 0; x < n; ++x) {
          const glm::vec2* from = sums.data() + x + n * (blockBefore(y) + n * blockBefore(z));
          row[x] = glm::mix(glm::mix(from[0], from[n], shareBehind(y)),
                            glm::mix(from[n * n], from[n * n + n], shareBehind(y)), shareBehind(z));
        }
        for (int x = 0; x < side; ++x, ++value) {
          const glm::vec2 part = glm::mix(row[blockBefore(x)], row[blockBefore(x) + 1], shareBehind(x));
          if (!(part.y > 0.0f)) continue;
          const float shift = std::clamp(-part.x / part.y, -most, most) * SmoothedIndicator::one;
          *value = held(static_cast<int>(static_cast<float>(*value) + shift + 0.5f), *value >= level);
        }
      }
  });
}

bool Smoothing::shiftAll() {
  double excess = 0.0, change = 0.0, volume = 0.0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    excess += double{parts_[i].x};
    change += double{parts_[i].y};
    volume += double{volumes_[i]};
  }
  constexpr double most = 0.1, enough = 1e-4;
  if (!(change > 0.0) || std::abs(excess) <= enough * volume) return true;
  const auto shift = static_cast<int>(std::lround(std::clamp(-excess / change, -most, most) * SmoothedIndicator::one));
  if (shift == 0) return true;
  parallelFor(values_.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) values_[i] = held(values_[i] + shift, values_[i] >= level);
  });
  return false;
}

}  // namespace

std::size_t TileMap::offset(glm::ivec3 tile) const {
  return static_cast<std::size_t>(tile.x) +
         static_cast<std::size_t>(count.x) *
             (static_cast<std::size_t>(tile.y) + static_cast<std::size_t>(count.y) * static_cast<std::size_t>(tile.z));
}

template <int perSide, class T>
void TileMap::read(const std::vector<T>& values, std::array<T, 2> alike, glm::ivec3 low, glm::ivec3 block,
                   T* to) const {
  constexpr int voxelsPerValue = side / perSide;
  const glm::ivec3 last = (dims - 1) / voxelsPerValue;
  for (int z = low.z; z < low.z + block.z; ++z)
    for (int y = low.y; y < low.y + block.y; ++y) {
      const glm::ivec2 at = glm::clamp(glm::ivec2(y, z), glm::ivec2(0), glm::ivec2(last.y, last.z));
      const std::size_t row = offset({0, at.x / perSide, at.y / perSide});
      const auto inTile = static_cast<std::size_t>(perSide * (at.x % perSide + perSide * (at.y % perSide)));
      const int end = low.x + block.x;
      for (int x = low.x; x < end;) {
        const int column = std::clamp(x, 0, last.x);
        int next = end;
        if (x < 0) next = std::min(end, 0);
        if (x == column) next = std::min({end, last.x + 1, (column / perSide + 1) * perSide});
        const std::uint32_t slot = slots[row + static_cast<std::size_t>(column / perSide)];
        const std::size_t first = (std::size_t{slot} - 2) * cubed(perSide) + inTile;
        if (slot < 2 || first >= values.size())
          std::fill_n(to, next - x, alike[slot < 2 ? slot : 0]);
        else if (x == column)
          std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(first) + column % perSide, next - x, to);
        else
          std::fill_n(to, next - x, values[first + static_cast<std::size_t>(column % perSide)]);
        to += next - x;
        x = next;
      }
    }
}

SmoothedIndicator::SmoothedIndicator(const LabelMap& map, std::span<const std::uint16_t> labels,
                                     LabelSmoothing strength) {
  Smoothing smoothing(tiles_, values_);
  if (map.voxels.type() == ScalarType::UInt8)
    smoothing.begin(map, map.voxels.as<std::uint8_t>(), labels);
  else
    smoothing.begin(map, map.voxels.as<std::uint16_t>(), labels);
  const int steps = strength == LabelSmoothing::Light ? 2 : 8;
  for (int step = 0; step < steps; ++step) {
    smoothing.diffuse();
    smoothing.measure(coarse);
    smoothing.shiftNear();
  }
  constexpr int lastNear = 4, lastOfAll = 8;
  for (int shift = 0; shift < lastNear; ++shift) {
    smoothing.measure(coarse);
    smoothing.shiftNear();
  }
  smoothing.measureWell();
  for (int shift = 0; shift < lastOfAll && !smoothing.shiftAll(); ++shift) smoothing.measureWell();
}

void SmoothedIndicator::read(glm::ivec3 low, glm::ivec3 size, std::uint16_t* to) const {
  tiles_.read<TileMap::side, std::uint16_t>(values_, {0, one}, low, size, to);
}

std::uint16_t SmoothedIndicator::at(glm::ivec3 voxel) const {
  std::uint16_t value = 0;
  read(voxel, glm::ivec3(1), &value);
  return value;
}

}  // namespace fenestra
