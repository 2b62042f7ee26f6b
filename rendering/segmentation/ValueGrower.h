#pragma once
// Growing by values: which voxels a seed reaches at which tolerance, through paths as wide as a small ball.

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "rendering/segmentation/Costs.h"
#include "rendering/segmentation/Flood.h"
#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {

/// visit(y, z, offset of the row) for all rows of a box of `dims`, on all cores.
template <class Visit>
void forRows(glm::ivec3 dims, Visit visit) {
  parallelFor(static_cast<std::size_t>(dims.z), 1, [&](std::size_t begin, std::size_t end) {
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      for (int y = 0; y < dims.y; ++y) visit(y, z, wholeOf(dims).offset({0, y, z}));
  });
}

class ValueGrower {
 public:
  /// `volume` outlives this.
  ValueGrower(const Volume& volume, const VoxelBox& box);

  /// The level at which each voxel of the box joins a region from `inside`, which has one seed at least; all seeds lie
  /// in the box. `progress` is called with fractions up to 0.8; empty when it returned false.
  std::optional<std::vector<Level>> joins(const std::vector<glm::ivec3>& inside, const std::vector<glm::ivec3>& outside,
                                          const std::function<bool(double)>& progress);

  /// By voxel of the box, after joins(): how far its value lies from the seeds inside.
  std::vector<Level> takeCosts() { return std::move(kinds_[0].costs); }
  const Noise& noise() const { return noise_; }

 private:
  /// One kind of seeds on its way to a flood.
  struct Kind {
    std::vector<glm::ivec3> seeds;  ///< in the box's frame
    std::vector<Level> costs;       ///< of the box's voxels
    std::vector<Level> wide;        ///< costs of paths as wide as the ball
    std::optional<PaddedLevels> paths;
  };

  bool computeCosts(const std::function<bool(double)>& goOn);
  void costsOf(const VoxelBox& tile, const std::vector<TissueCost>& tissues, EdgeSharpener& sharpener);
  void preparePaths(Kind& kind);
  std::optional<Flooded> floodBox(const std::function<bool(double)>& goOn);
  std::vector<Level> putBallsBack(const Flooded& flooded);

  const Volume& volume_;
  VoxelBox box_;
  double side_;
  std::array<Level, 256> thin_;
  Noise noise_;
  std::optional<ToneScale> scale_;
  std::array<Kind, 2> kinds_;  ///< inside, outside
};

}  // namespace fenestra::segmentation
