#include "rendering/segmentation/BoneJoints.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "rendering/segmentation/BoneVoxels.h"
#include "rendering/segmentation/Smoothing.h"

namespace fenestra::segmentation {
namespace {

// Chosen on the marked structures of tests/bench/results/growing.md; 2 and 4 mm do nearly as well.
constexpr double widestGap = 3.0;  ///< mm between two parts that face each other: a joint's cartilage
constexpr double sideDepth = 3.0;  ///< mm behind the border: where the plate of dense bone at a joint lies
/// In noise the greatest values beside a border and the least on it differ with no gap. HU, and deviations of what is
/// louder: the weight of a gap was chosen in usual noise, and holds for that.
constexpr double usualNoise = 22.0, gapOfNoise = 2.5;

/// Walks along the axes of the volume across the borders.
template <class Stored>
class GapFinder {
 public:
  GapFinder(std::span<const Stored> scalars, const Volume& volume, double noise, const VoxelSet& voxels,
            std::span<const std::uint32_t> parts, BoneMeetings& meetings)
      : scalars_(scalars),
        volume_(volume),
        voxels_(voxels),
        parts_(parts),
        meetings_(meetings),
        dims_(volume.grid.dims),
        bias_(gapOfNoise * std::max(0.0, noise - usualNoise)) {
    const VoxelBox whole = wholeOf(dims_);
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 next(0);
      next[axis] = 1;
      const glm::dvec3 a = volume.grid.direction[(axis + 1) % 3] * volume.grid.spacing[(axis + 1) % 3];
      const glm::dvec3 b = volume.grid.direction[(axis + 2) % 3] * volume.grid.spacing[(axis + 2) % 3];
      const auto voxelsIn = [&](double mm) {
        return std::max(1, static_cast<int>(std::lround(mm / volume.grid.spacing[axis])));
      };
      axes_[static_cast<std::size_t>(axis)] = {whole.offset(next), glm::length(glm::cross(a, b)), voxelsIn(widestGap),
                                               voxelsIn(sideDepth)};
    }
  }

  bool run(const std::function<bool()>& goOn) {
    constexpr std::uint32_t often = 1 << 16;  // voxels: some milliseconds
    const VoxelBox whole = wholeOf(dims_);
    for (std::uint32_t number = 0; number < voxels_.size(); ++number) {
      if (number % often == 0 && goOn && !goOn()) return false;
      const std::size_t offset = voxels_.offsets()[number];
      const glm::ivec3 at = whole.at(offset);
      for (int axis = 0; axis < 3; ++axis) across(axis, at[axis], offset, parts_[number]);
    }
    return true;
  }

 private:
  struct Axis {
    std::size_t step = 0;
    double area = 0.0;  ///< mm²
    int gap = 1, depth = 1;
  };

  double value(std::size_t offset) const { return finiteValue(scalars_[offset], volume_); }
  bool isOf(std::uint32_t part, std::size_t offset) const {
    return voxels_.holds(offset) && parts_[voxels_.numberOf(offset)] == part;
  }

  /// From a voxel of `part` at `index` of the axis to the next part, if one is near.
  void across(int axis, int index, std::size_t from, std::uint32_t part) {
    const Axis& along = axes_[static_cast<std::size_t>(axis)];
    std::size_t to = from;
    int steps = 0;
    do {
      ++steps;
      to += along.step;
      if (index + steps >= dims_[axis] || steps > along.gap + 1) return;
    } while (!voxels_.holds(to));
    const std::uint32_t other = parts_[voxels_.numberOf(to)];
    if (other == part) return;
    double least = value(from), near = least, far = value(to);
    for (std::size_t between = from; between != to;) least = std::min(least, value(between += along.step));
    for (int i = 1; i <= along.depth && index >= i; ++i) {
      const std::size_t behind = from - static_cast<std::size_t>(i) * along.step;
      if (!isOf(part, behind)) break;
      near = std::max(near, value(behind));
    }
    for (int i = 1; i <= along.depth && index + steps + i < dims_[axis]; ++i) {
      const std::size_t behind = to + static_cast<std::size_t>(i) * along.step;
      if (!isOf(other, behind)) break;
      far = std::max(far, value(behind));
    }
    const double side = std::min(near, far);
    const BoneMeeting face{0.0, along.area * (side - least - bias_), along.area * std::max(boneFrom, side)};
    meetings_[part][other].add(face);
    meetings_[other][part].add(face);
  }

  std::span<const Stored> scalars_;
  const Volume& volume_;
  const VoxelSet& voxels_;
  std::span<const std::uint32_t> parts_;
  BoneMeetings& meetings_;
  glm::ivec3 dims_;
  std::array<Axis, 3> axes_;
  double bias_;  ///< HU: a dip that loud noise makes
};

}  // namespace

void BoneMeeting::add(const BoneMeeting& other) {
  depth = std::max(depth, other.depth);
  dip += other.dip;
  side += other.side;
}

bool addGaps(const Volume& volume, double noise, const VoxelSet& voxels, std::span<const std::uint32_t> parts,
             BoneMeetings& meetings, const std::function<bool()>& goOn) {
  return volume.voxels.visit([&](auto scalars) {
    using Stored = typename decltype(scalars)::value_type;
    return GapFinder<Stored>(scalars, volume, noise, voxels, parts, meetings).run(goOn);
  });
}

}  // namespace fenestra::segmentation
