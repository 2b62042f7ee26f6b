#pragma once
// A set of voxels that can tell their numbers, and who lies beside whom.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rendering/segmentation/VoxelBox.h"

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

/// The up to 26 neighbours of voxels in a box.
class Neighbours {
 public:
  explicit Neighbours(const VoxelBox& whole) : whole_(whole), inner_(whole.grownBy(glm::ivec3(-1))) {
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
          if (const glm::ivec3 step(x, y, z); step != glm::ivec3(0))
            steps_[count_++] = {step, whole.offset(whole.low + 1 + step) - whole.offset(whole.low + 1)};
  }

  /// visit(step, offset in the box) in memory order.
  template <class Visit>
  void visit(std::size_t offset, Visit visit) const {
    const glm::ivec3 at = whole_.at(offset);
    const bool isInner = inner_.contains(at);
    for (const Step& each : steps_)
      if (isInner || whole_.contains(at + each.step)) visit(each.step, offset + each.away);
  }

 private:
  struct Step {
    glm::ivec3 step{0};
    std::size_t away = 0;  ///< wraps around where it goes back
  };
  VoxelBox whole_, inner_;
  std::array<Step, 26> steps_;
  std::size_t count_ = 0;
};

}  // namespace fenestra::segmentation
