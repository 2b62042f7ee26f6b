#pragma once
// A set of voxels that can tell their numbers.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fenestra::segmentation {

/// Members are numbered in memory order. Takes a bit for each voxel of the volume, half as much for the numbers, and
/// four bytes a member.
class VoxelSet {
 public:
  VoxelSet() = default;
  /// The voxels with other values than 0. Fewer than 2³² voxels.
  explicit VoxelSet(std::span<const std::uint8_t> mask) : words_((mask.size() + 63) / 64), before_(words_.size()) {
    for (std::size_t word = 0; word < words_.size(); ++word) {
      before_[word] = static_cast<std::uint32_t>(offsets_.size());
      for (std::size_t i = 64 * word; i < std::min(mask.size(), 64 * word + 64); ++i)
        if (mask[i] != 0) {
          words_[word] |= std::uint64_t{1} << (i % 64);
          offsets_.push_back(static_cast<std::uint32_t>(i));
        }
    }
    offsets_.shrink_to_fit();
  }

  std::size_t size() const { return offsets_.size(); }
  /// By number: the voxel's offset in the volume, ascending.
  std::span<const std::uint32_t> offsets() const { return offsets_; }
  bool holds(std::size_t offset) const { return (words_[offset / 64] >> (offset % 64) & 1) != 0; }
  /// The number of a member.
  std::uint32_t numberOf(std::size_t offset) const {
    const std::uint64_t lower = words_[offset / 64] & ((std::uint64_t{1} << (offset % 64)) - 1);
    return before_[offset / 64] + static_cast<std::uint32_t>(std::popcount(lower));
  }
  std::size_t heldBytes() const {
    return words_.size() * (sizeof(std::uint64_t) + sizeof(std::uint32_t)) + offsets_.size() * sizeof(std::uint32_t);
  }

 private:
  std::vector<std::uint64_t> words_;   ///< a bit a voxel
  std::vector<std::uint32_t> before_;  ///< by word: members in the words before it
  std::vector<std::uint32_t> offsets_;
};

}  // namespace fenestra::segmentation
