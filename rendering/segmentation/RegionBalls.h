#pragma once
// The balls that a region holds: how thick its parts are, and which part a seed lies in.

#include <span>
#include <vector>

#include "rendering/segmentation/Levels.h"
#include "rendering/segmentation/Morphology.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Grid.h"

namespace fenestra::segmentation {

/// The depth of a leak's ball over that of the part that is meant: a narrow place lies between both.
inline constexpr double leakThickness = 1.5;

struct HeldBall {
  glm::ivec3 centre{0};
  double radius = 0.0;  ///< mm
  /// mm: the radius where a face of the volume does not bound the ball. The scan ends there, not the structure.
  double depth = 0.0;
};

/// The largest balls that the voxels with `joins` < `step` hold. No ball is larger than 25 mm or 40 sides of a voxel.
class RegionBalls {
 public:
  /// `joins` are of the grid's voxels, and outlive this.
  RegionBalls(const Grid& grid, std::span<const Level> joins, int step);

  bool holds(glm::ivec3 voxel) const { return whole_.contains(voxel) && joins_[whole_.offset(voxel)] < step_; }
  /// The largest ball around a voxel that the region holds.
  HeldBall ballAt(glm::ivec3 voxel) const;
  /// The ball of the part that a ball lies in: from ball to ball nearby while they grow.
  HeldBall bodyOf(const HeldBall& ball) const { return grown(ball, &HeldBall::radius); }
  /// mm: how deep the part is that a ball lies in, found in the same way by depths.
  double depthOf(const HeldBall& ball) const { return grown(ball, &HeldBall::depth).depth; }
  /// Whether a seed outside, with the ball around it, means the body that a seed inside lies in: it lies in its middle,
  /// or far nearer to it than the seed inside does.
  bool means(const HeldBall& outside, const HeldBall& inside, const HeldBall& body) const;

  double voxelSide() const { return side_; }  ///< mm
  /// The voxels of the largest ball, the nearest first.
  const std::vector<BallOffset>& offsets() const { return offsets_; }

 private:
  HeldBall grown(HeldBall ball, double HeldBall::*measure) const;
  double lengthOf(glm::ivec3 offset) const;  ///< mm

  VoxelBox whole_;
  std::span<const Level> joins_;
  int step_;
  glm::dmat4 worldFromIndex_;
  double side_;     ///< mm, of a voxel
  double largest_;  ///< mm: radius
  std::vector<BallOffset> offsets_;
};

}  // namespace fenestra::segmentation
