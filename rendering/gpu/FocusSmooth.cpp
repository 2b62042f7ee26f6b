#include "rendering/gpu/FocusSmooth.h"

#include <algorithm>
#include <bit>

namespace fenestra {
namespace {

constexpr int side = FocusSmooth::tileSide;
constexpr int taps = 9;
constexpr std::uint32_t allTaps = (1u << taps) - 1;

std::size_t offsetIn(glm::ivec3 size, glm::ivec3 at) {
  return static_cast<std::size_t>(at.x) +
         static_cast<std::size_t>(size.x) *
             (static_cast<std::size_t>(at.y) + static_cast<std::size_t>(size.y) * static_cast<std::size_t>(at.z));
}

int floorTo(int value, int multiple) { return (value >= 0 ? value : value - multiple + 1) / multiple * multiple; }
glm::ivec3 floorTo(glm::ivec3 value, int multiple) {
  return {floorTo(value.x, multiple), floorTo(value.y, multiple), floorTo(value.z, multiple)};
}

/// The filter's sums along x, of 256, for two neighbouring voxels: entry i has voxel j in the focus where its bit j
/// is 1.
using PairSums = std::array<std::array<std::uint16_t, 2>, 2 << taps>;
constexpr PairSums pairSums() {
  constexpr std::array<std::uint16_t, taps> weights{1, 8, 28, 56, 70, 56, 28, 8, 1};
  PairSums sums{};
  for (std::uint32_t bits = 0; bits < sums.size(); ++bits)
    for (std::uint32_t voxel = 0; voxel < 2; ++voxel)
      for (std::uint32_t tap = 0; tap < taps; ++tap)
        if (bits >> (voxel + tap) & 1u)
          sums[bits][voxel] = static_cast<std::uint16_t>(sums[bits][voxel] + weights[tap]);
  return sums;
}

using Row = std::array<std::uint16_t, static_cast<std::size_t>(side)>;

void filterAlongX(std::uint32_t bits, Row& sums) {
  static constexpr PairSums pairs = pairSums();
  for (std::size_t x = 0; x < sums.size(); x += 2) {
    const auto& pair = pairs[bits >> x & (2 * allTaps + 1)];
    sums[x] = pair[0];
    sums[x + 1] = pair[1];
  }
}

/// (1 4 6 4 1) without a division.
void filterOnce(const Row* from, Row& to) {
  for (std::size_t x = 0; x < to.size(); ++x)
    to[x] = static_cast<std::uint16_t>(from[0][x] + from[4][x] + 4 * (from[1][x] + from[3][x]) + 6 * from[2][x]);
}

/// Filters results of filterOnce, which are at most 4096. The sum is exact, but 65536, where all voxels are in the
/// focus, becomes 65535 to fit 16 bits.
void filterAgain(const Row* from, Row& to) {
  for (std::size_t x = 0; x < to.size(); ++x) {
    const std::uint32_t sum = from[0][x] + from[4][x] + 4u * (from[1][x] + from[3][x]) + 6u * from[2][x];
    to[x] = static_cast<std::uint16_t>(sum - (sum >> 16));
  }
}

/// (1 8 28 56 70 56 28 8 1), rounded, of the rows at(0) to at(8).
template <class At>
void filterAlongZ(At at, std::uint16_t* to) {
  for (std::size_t x = 0; x < static_cast<std::size_t>(side); ++x) {
    const auto value = [&](std::size_t tap) -> std::uint32_t { return at(tap)[x]; };
    // By shifts: 28, 56 and 70 are multiples of 7 · 2.
    const std::uint32_t inner = 2 * (value(2) + value(6)) + 4 * (value(3) + value(5)) + 5 * value(4);
    const std::uint32_t sum = value(0) + value(8) + 8 * (value(1) + value(7)) + 16 * inner - 2 * inner;
    to[x] = static_cast<std::uint16_t>((sum + 128) >> 8);
  }
}

}  // namespace

FocusSmooth::FocusSmooth(const FocusIndex& index, glm::ivec3 dims) : index_(index), dims_(dims) {
  static_assert(tileSide % brickSide == 0 && reach == brickSide, "a tile's surroundings are whole bricks");
  if (!index.box) return;
  constexpr int margin = reach + 1;
  box_.origin = floorTo(index.box->low - margin, tileSide);
  box_.size = floorTo(index.box->high + margin, tileSide) + tileSide - box_.origin;
  // Mesa's software rasteriser compiles programs again where a side becomes a power of two.
  for (int axis = 0; axis < 3; ++axis)
    while (std::has_single_bit(static_cast<unsigned>(box_.size[axis]))) box_.size[axis] += tileSide;
}

std::vector<glm::ivec3> FocusSmooth::marked(const std::vector<std::uint8_t>& marks) const {
  std::vector<glm::ivec3> tiles;
  std::size_t at = 0;
  glm::ivec3 tile;
  for (tile.z = 0; tile.z < tileCount().z; ++tile.z)
    for (tile.y = 0; tile.y < tileCount().y; ++tile.y)
      for (tile.x = 0; tile.x < tileCount().x; ++tile.x)
        if (marks[at++]) tiles.push_back(box_.origin + tile * tileSide);
  return tiles;
}

std::vector<glm::ivec3> FocusSmooth::tiles() const {
  std::vector<std::size_t> bricks;
  for (std::size_t brick = 0; brick < index_.slots.size(); ++brick)
    if (index_.slots[brick] != 0) bricks.push_back(brick);
  return tilesNear(bricks);
}

std::vector<glm::ivec3> FocusSmooth::tilesNear(const std::vector<std::size_t>& bricks) const {
  constexpr int bricksPerTile = tileSide / brickSide;
  const glm::ivec3 count = tileCount(), first = box_.origin / tileSide, lastBrick = (dims_ - 1) / brickSide;
  std::vector<std::uint8_t> marks(offsetIn(count, {0, 0, count.z}), 0);
  const auto x = static_cast<std::size_t>(index_.bricks.x), y = static_cast<std::size_t>(index_.bricks.y);
  for (const std::size_t offset : bricks) {
    const glm::ivec3 brick(offset % x, offset / x % y, offset / (x * y));
    glm::ivec3 low, high;
    for (int axis = 0; axis < 3; ++axis) {
      // What repeats the volume's edge depends on its outermost voxels.
      low[axis] = brick[axis] == 0 ? 0 : (brick[axis] - 1) / bricksPerTile - first[axis];
      high[axis] = brick[axis] >= lastBrick[axis] ? count[axis] - 1 : (brick[axis] + 1) / bricksPerTile - first[axis];
    }
    low = glm::max(low, 0);
    high = glm::min(high, count - 1);
    for (int tileZ = low.z; tileZ <= high.z; ++tileZ)
      for (int tileY = low.y; tileY <= high.y; ++tileY)
        for (int tileX = low.x; tileX <= high.x; ++tileX) marks[offsetIn(count, {tileX, tileY, tileZ})] = 1;
  }
  return marked(marks);
}

void FocusSmooth::read(glm::ivec3 tile, Bits& bits) const {
  constexpr int bricks = blockSide / brickSide;
  const auto orRow = [&](glm::ivec3 brick, int y, int z, std::uint32_t four) {
    bits[static_cast<std::size_t>(brick.y * brickSide + y + blockSide * (brick.z * brickSide + z))] |=
        four << (brick.x * brickSide);
  };
  // A block beyond the volume holds what one at its last brick does once the edge is repeated.
  const glm::ivec3 first = glm::min(tile / brickSide - 1, dims_ / brickSide);
  const glm::ivec3 low = glm::max(-first, 0), high = glm::min(index_.bricks - first, bricks);
  glm::ivec3 brick;
  for (brick.z = low.z; brick.z < high.z; ++brick.z)
    for (brick.y = low.y; brick.y < high.y; ++brick.y)
      for (brick.x = low.x; brick.x < high.x; ++brick.x) {
        const std::uint32_t slot = index_.slots[brickOffset(index_.bricks, first + brick)];
        if (slot == 0) continue;
        for (int z = 0, word = 0; z < brickSide; ++z)
          for (int y = 0; y < brickSide; ++y, ++word) {
            if (slot == 1) {
              orRow(brick, y, z, 15u);
              continue;
            }
            // The voxel at an index is the last corner of the cell of that number: bit 7 of each byte. The product
            // gathers them in its highest byte.
            const std::uint32_t cells = index_.cells[(slot - 2) * (cellsPerBrick / 4) + static_cast<std::size_t>(word)];
            orRow(brick, y, z, (cells >> 7 & 0x01010101u) * 0x01020408u >> 24);
          }
      }
  repeatEdge(first * brickSide, bits);
}

void FocusSmooth::repeatEdge(glm::ivec3 low, Bits& bits) const {
  // First and last voxel of the block that the index holds: it repeats the edge once at the volume's end.
  const glm::ivec3 first = glm::clamp(-low, 0, blockSide - 1), last = glm::clamp(dims_ - low, 0, blockSide - 1);
  if (first == glm::ivec3(0) && last == glm::ivec3(blockSide - 1)) return;
  const std::uint32_t before = (1u << first.x) - 1, after = ~((2u << last.x) - 1) & ((1u << blockSide) - 1);
  for (std::uint32_t& row : bits) {
    if (row >> first.x & 1u) row |= before;
    row = row >> last.x & 1u ? row | after : row & ~after;
  }
  const auto rowOf = [&](int y, int z) -> std::uint32_t& { return bits[static_cast<std::size_t>(y + blockSide * z)]; };
  for (int z = 0; z < blockSide; ++z)
    for (int y = 0; y < blockSide; ++y)
      rowOf(y, z) = rowOf(std::clamp(y, first.y, last.y), std::clamp(z, first.z, last.z));
}

void FocusSmooth::makeSmoothed(glm::ivec3 tile, Tile& voxels) const {
  constexpr auto wide = static_cast<std::size_t>(blockSide), narrow = static_cast<std::size_t>(side);
  std::array<std::uint16_t, wide * wide * wide> block;
  index_.smoothed->read(tile - reach, glm::ivec3(blockSide), block.data());
  if ((block[0] == 0 || block[0] == 65535) &&
      std::all_of(block.begin(), block.end(), [&](std::uint16_t value) { return value == block[0]; })) {
    voxels.fill(block[0]);
    return;
  }
  const auto sum = [](const auto* from, std::size_t step) {
    constexpr std::array<float, taps> weights{1, 8, 28, 56, 70, 56, 28, 8, 1};
    float total = 0.0f;
    for (std::size_t tap = 0; tap < weights.size(); ++tap) total += weights[tap] * static_cast<float>(from[tap * step]);
    return total * (1.0f / 256.0f);
  };
  std::array<float, narrow * wide * wide> alongX;
  for (std::size_t row = 0; row < wide * wide; ++row)
    for (std::size_t x = 0; x < narrow; ++x) alongX[row * narrow + x] = sum(block.data() + row * wide + x, 1);
  std::array<float, narrow * narrow * wide> alongY;
  for (std::size_t z = 0; z < wide; ++z)
    for (std::size_t at = 0; at < narrow * narrow; ++at)
      alongY[z * narrow * narrow + at] = sum(alongX.data() + z * narrow * wide + at, narrow);
  for (std::size_t at = 0; at < voxels.size(); ++at)
    voxels[at] = static_cast<std::uint16_t>(sum(alongY.data() + at, narrow * narrow) + 0.5f);
}

void FocusSmooth::make(glm::ivec3 tile, Tile& voxels) const {
  if (index_.smoothed) {
    makeSmoothed(tile, voxels);
    return;
  }
  Bits bits{};
  read(tile, bits);
  constexpr std::uint32_t full = (1u << blockSide) - 1;
  if (std::all_of(bits.begin(), bits.end(), [&](std::uint32_t row) { return row == bits[0]; }) &&
      (bits[0] == 0 || bits[0] == full)) {
    voxels.fill(bits[0] == 0 ? 0 : 65535);
    return;
  }
  // Most of what a surface passes is all inside or all outside along it: only rows that are neither are filtered.
  const auto valueOf = [](std::uint32_t any, std::uint32_t all) -> int {
    return any == 0 ? 0 : all == full ? 65535 : -1;
  };
  std::array<Row, static_cast<std::size_t>(blockSide)> rows;
  std::array<Row, static_cast<std::size_t>(blockSide - reach)> once;
  std::array<std::array<Row, static_cast<std::size_t>(side)>, static_cast<std::size_t>(blockSide)> planes;
  std::array<std::array<int, static_cast<std::size_t>(side)>, static_cast<std::size_t>(blockSide)> values;
  for (std::size_t z = 0; z < planes.size(); ++z) {
    const std::uint32_t* plane = bits.data() + rows.size() * z;
    std::size_t first = planes[z].size(), end = 0;  // rows to be filtered
    for (std::size_t y = 0; y < planes[z].size(); ++y) {
      std::uint32_t any = 0, all = full;
      for (std::size_t tap = 0; tap < static_cast<std::size_t>(taps); ++tap) {
        any |= plane[y + tap];
        all &= plane[y + tap];
      }
      values[z][y] = valueOf(any, all);
      if (values[z][y] >= 0) {
        planes[z][y].fill(static_cast<std::uint16_t>(values[z][y]));
        continue;
      }
      first = std::min(first, y);
      end = y + 1;
    }
    if (first >= end) continue;
    for (std::size_t y = first; y < end + 2 * reach; ++y) filterAlongX(plane[y], rows[y]);
    // A voxel is at most 256, then 4096, then 65535.
    for (std::size_t y = first; y < end + reach; ++y) filterOnce(&rows[y], once[y]);
    for (std::size_t y = first; y < end; ++y) filterAgain(&once[y], planes[z][y]);
  }
  for (std::size_t z = 0; z < static_cast<std::size_t>(side); ++z)
    for (std::size_t y = 0; y < static_cast<std::size_t>(side); ++y) {
      std::uint16_t* to = voxels.data() + static_cast<std::size_t>(side) * (y + static_cast<std::size_t>(side) * z);
      bool same = values[z][y] >= 0;
      for (std::size_t tap = 1; tap < static_cast<std::size_t>(taps); ++tap)
        same = same && values[z + tap][y] == values[z][y];
      if (same) {
        std::fill_n(to, side, static_cast<std::uint16_t>(values[z][y]));
        continue;
      }
      filterAlongZ([&](std::size_t tap) -> const Row& { return planes[z + tap][y]; }, to);
    }
}

}  // namespace fenestra
