#include "rendering/gpu/FocusSmooth.h"

#include <algorithm>
#include <array>
#include <type_traits>

#include "rendering/scene/Parallel.h"

namespace fenestra {
namespace {

constexpr int reach = 4;           ///< voxels: two passes of a five-tap filter
constexpr int margin = reach + 1;  ///< a gradient reads one more
constexpr int tileSide = 16;       ///< voxels: a tile with what is read around it fits a core's first cache
constexpr int blockSide = tileSide + 2 * reach;

std::size_t offsetIn(glm::ivec3 size, glm::ivec3 at) {
  return static_cast<std::size_t>(at.x) +
         static_cast<std::size_t>(size.x) *
             (static_cast<std::size_t>(at.y) + static_cast<std::size_t>(size.y) * static_cast<std::size_t>(at.z));
}

/// A tile with what the filter reads around it. Each pass along an axis shortens it there by two voxels at both ends.
class Block {
 public:
  std::uint16_t& at(glm::ivec3 index) { return values_[offsetIn(glm::ivec3(blockSide), index)]; }

  void filter() {
    glm::ivec3 low(0), high(blockSide);
    for (int pass = 0; pass < 2; ++pass)
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] += 2;
        high[axis] -= 2;
        filterAlong(axis, low, high);
      }
  }

 private:
  /// For the voxels of [low, high).
  void filterAlong(int axis, glm::ivec3 low, glm::ivec3 high) {
    const std::ptrdiff_t step = axis == 0 ? 1 : axis == 1 ? blockSide : blockSide * blockSide;
    for (int z = low.z; z < high.z; ++z)
      for (int y = low.y; y < high.y; ++y) {
        const std::uint16_t* from = &at({low.x, y, z});
        std::uint16_t* to = &filtered_[offsetIn(glm::ivec3(blockSide), {low.x, y, z})];
        for (int x = 0; x < high.x - low.x; ++x) {
          const std::uint16_t* v = from + x;
          const std::uint32_t sum = std::uint32_t{v[-2 * step]} + v[2 * step] +
                                    4 * (std::uint32_t{v[-step]} + v[step]) + 6 * std::uint32_t{v[0]};
          to[x] = static_cast<std::uint16_t>((sum + 8) / 16);
        }
      }
    std::swap(values_, filtered_);
  }

  static constexpr std::size_t count = static_cast<std::size_t>(blockSide) * blockSide * blockSide;
  std::vector<std::uint16_t> values_ = std::vector<std::uint16_t>(count), filtered_ = values_;
};

class Smoother {
 public:
  Smoother(const LabelMap& labels, const LabelFocus& focus, const FocusIndex& index, FocusSmooth& smooth)
      : labels_(labels), index_(index), smooth_(smooth), wanted_(1 << 16, 0) {
    for (const std::uint16_t label : focus.labels) wanted_[label] = 65535;
    const glm::ivec3 end = smooth.origin + smooth.size;
    // Tiles begin at voxels 0, 16, …; those of the margin before the volume too.
    first_ = (smooth.origin + tileSide) / tileSide - 1;
    tiles_ = (end + tileSide - 1) / tileSide - first_;
  }

  void run() {
    labels_.voxels.visit([&](auto values) {
      if constexpr (std::is_unsigned_v<typename decltype(values)::value_type>)
        parallelFor(static_cast<std::size_t>(tiles_.y) * static_cast<std::size_t>(tiles_.z), 1,
                    [&](std::size_t begin, std::size_t end) {
                      Block block;
                      for (std::size_t row = begin; row < end; ++row)
                        for (int x = 0; x < tiles_.x; ++x) {
                          const auto at = static_cast<int>(row);
                          fill((first_ + glm::ivec3(x, at % tiles_.y, at / tiles_.y)) * tileSide, values, block);
                        }
                    });
    });
  }

 private:
  /// 0 or 1 where all that a tile's filter reads is outside or inside, else 2.
  std::uint32_t slotAround(glm::ivec3 tile) const {
    // A brick's first corner is one voxel before brick · brickSide, its last one is brickSide further.
    const auto brickOf = [&](glm::ivec3 voxel) {
      return (glm::clamp(voxel, glm::ivec3(0), labels_.grid.dims - 1) + 1) / brickSide;
    };
    const glm::ivec3 low = brickOf(tile - reach), high = brickOf(tile + tileSide - 1 + reach);
    const std::uint32_t slot = std::min(2u, index_.slots[brickOffset(index_.bricks, low)]);
    glm::ivec3 brick;
    for (brick.z = low.z; brick.z <= high.z; ++brick.z)
      for (brick.y = low.y; brick.y <= high.y; ++brick.y)
        for (brick.x = low.x; brick.x <= high.x; ++brick.x)
          if (std::min(2u, index_.slots[brickOffset(index_.bricks, brick)]) != slot) return 2;
    return slot;
  }

  template <class Labels>
  void fill(glm::ivec3 tile, Labels values, Block& block) {
    const std::uint32_t slot = slotAround(tile);
    if (slot == 0) return;  // as it is already
    if (slot == 2) read(tile, values, block);
    const glm::ivec3 low = glm::max(tile, smooth_.origin),
                     high = glm::min(tile + tileSide, smooth_.origin + smooth_.size);
    for (int z = low.z; z < high.z; ++z)
      for (int y = low.y; y < high.y; ++y) {
        std::uint16_t* to = &smooth_.field[offsetIn(smooth_.size, glm::ivec3(low.x, y, z) - smooth_.origin)];
        if (slot == 1)
          std::fill_n(to, high.x - low.x, std::uint16_t{65535});
        else
          std::copy_n(&block.at(glm::ivec3(low.x, y, z) - tile + reach), high.x - low.x, to);
      }
  }

  template <class Labels>
  void read(glm::ivec3 tile, Labels values, Block& block) {
    const glm::ivec3 last = labels_.grid.dims - 1;
    for (int z = 0; z < blockSide; ++z)
      for (int y = 0; y < blockSide; ++y) {
        const glm::ivec3 voxel = tile - reach + glm::ivec3(0, y, z);
        const auto* row =
            values.data() + labels_.grid.offset({0, std::clamp(voxel.y, 0, last.y), std::clamp(voxel.z, 0, last.z)});
        std::uint16_t* to = &block.at({0, y, z});
        for (int x = 0; x < blockSide; ++x)
          to[x] = wanted_[static_cast<std::uint16_t>(row[std::clamp(voxel.x + x, 0, last.x)])];
      }
    block.filter();
  }

  const LabelMap& labels_;
  const FocusIndex& index_;
  FocusSmooth& smooth_;
  std::vector<std::uint16_t> wanted_;  ///< the field's value by label
  glm::ivec3 first_, tiles_;
};

}  // namespace

FocusSmooth smoothFocus(const LabelMap& labels, const LabelFocus& focus, const FocusIndex& index) {
  FocusSmooth smooth;
  smooth.origin = index.box->low - margin;
  smooth.size = index.box->high - index.box->low + 1 + 2 * margin;
  smooth.field.assign(offsetIn(smooth.size, {0, 0, smooth.size.z}), 0);
  Smoother(labels, focus, index, smooth).run();
  return smooth;
}

}  // namespace fenestra
