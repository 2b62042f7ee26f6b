#pragma once
// Which voxels a seed reaches at which tolerance, and who reaches them first.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rendering/segmentation/Levels.h"
#include "rendering/segmentation/VoxelBox.h"

namespace fenestra::segmentation {

/// Levels of a box with a border of one voxel of `never`, so that a flood needs no look at the box's faces.
class PaddedLevels {
 public:
  explicit PaddedLevels(glm::ivec3 dims)
      : padded_(wholeOf(dims).grownBy(glm::ivec3(1))), levels_(padded_.count(), never) {}

  glm::ivec3 dims() const { return padded_.dims() - 2; }
  std::size_t offset(glm::ivec3 index) const { return padded_.offset(index); }
  Level* row(int y, int z) { return levels_.data() + offset({0, y, z}); }
  const Level* row(int y, int z) const { return levels_.data() + offset({0, y, z}); }
  std::vector<Level>& all() { return levels_; }
  const std::vector<Level>& all() const { return levels_; }

 private:
  VoxelBox padded_;
  std::vector<Level> levels_;
};

/// One kind of seeds: what its paths cost, and where they start.
struct FloodSource {
  const PaddedLevels* costs = nullptr;
  std::vector<glm::ivec3> seeds;
};

struct Flooded {
  PaddedLevels reached;  ///< by the inside: least over all paths from a seed of the greatest cost on the way
  std::vector<std::uint8_t> outside;  ///< padded like `reached`: 1 where the outside came first; empty without one
};

/// Minimax path costs over faces, found in one pass over buckets of levels. Inside and outside seeds compete: a voxel
/// belongs to the kind that reaches it at the lower level, at equal levels to the one with fewer steps, and stops the
/// other. (Relative fuzzy connectedness: Udupa, Saha, Lotufo, IEEE TPAMI 24, 2002; as one flood: Falcão, Stolfi,
/// Lotufo, "The image foresting transform", IEEE TPAMI 26, 2004.) `outside.costs` may be null. `goOn` is asked now and
/// then with the share of levels done; when it returns false the flood ends early and its result means nothing.
Flooded flood(const FloodSource& inside, const FloodSource& outside, const std::function<bool(double)>& goOn);

}  // namespace fenestra::segmentation
