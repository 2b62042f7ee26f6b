#pragma once
// Which region a seed means: by values, by tissues, a bone, a tube or a walk's, whichever is clearest (Curve.h).

#include <optional>
#include <span>
#include <vector>

#include "rendering/segmentation/Curve.h"
#include "rendering/segmentation/GrowthMemory.h"
#include "rendering/segmentation/Levels.h"
#include "rendering/segmentation/RandomWalk.h"
#include "rendering/segmentation/TubeTracer.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// The ball that bounds a region, where there is one.
struct RegionBall {
  glm::dvec3 centre{0.0};  ///< world mm
  double radius = 0.0;     ///< mm
};
/// Nothing joins outside the ball. `joins` are of the voxels of `box`.
void keepTo(const std::optional<RegionBall>& ball, const Grid& grid, const VoxelBox& box, std::vector<Level>& joins);

/// In a whole volume. Takes a byte a voxel or two while it runs, on all cores.
class Competition {
 public:
  /// All outlive this; `bones` is null where there are none.
  Competition(const Volume& volume, const TissueTree& tissues, const BoneTree* bones,
              const std::optional<RegionBall>& ball)
      : volume_(volume), tissues_(tissues), bones_(bones), ball_(ball) {}

  /// Replaces a region by values with the one by tissues, the bone, the tube or the walk's where that is clearer, one
  /// of marrow with its bone, and begins with the clearest step.
  void decide(FirstRegion& region) const { decide(region, {}); }

  /// The clearest region of a first one's seed that holds no voxel of `outside`, and is no larger than the first one;
  /// where none is clear, the largest one by tissues. Empty where every region with the seed holds one of them.
  std::optional<FirstRegion> without(std::span<const glm::ivec3> outside, const FirstRegion& first) const;

  /// What a further seed means beside a first one's region: the clearest tissue or bone of `prior`.
  struct Region {
    std::vector<Level> joins;
    int step = 1;
  };
  Region further(glm::ivec3 seed, const StructurePrior& prior, const FirstRegion& first) const;
  /// The tube that holds a further seed; empty where there is none, or the first region is no tube.
  std::optional<Region> furtherTube(glm::ivec3 seed, const FirstRegion& first) const;

  /// The walk's region of a first one's seed with further seeds as ends of the walk; empty where one lies too far away
  /// for the walk, or where the first region is none.
  std::optional<Region> furtherWalk(std::span<const glm::ivec3> inside, std::span<const glm::ivec3> outside,
                                    const FirstRegion& first) const;

  StructurePrior priorOf(const FirstRegion& region) const;
  GrowthCurve curveOf(const std::vector<Level>& joins, std::span<const Level> costs, const Noise& noise) const;
  /// The curve of a region that `first` has become: by its own costs, and a bone's by how dense its voxels are.
  GrowthCurve curveOf(const std::vector<Level>& joins, const FirstRegion& first) const;
  double bodyVolume() const { return tissues_.bodyVolume(); }  ///< mm³

 private:
  /// False where no region is clear; then it begins as it did.
  bool decide(FirstRegion& region, std::span<const glm::ivec3> outside) const;
  /// The tube at a seed where it is clearer than `other`, by the costs of `first`.
  std::optional<TubeRegion> clearerTube(glm::ivec3 seed, const FirstRegion& first, const StructurePrior& prior,
                                        const std::optional<ClearestStep>& other) const;
  /// Sets what tells of a leak: GrowthCurve::lead beside the regions of `others`, and GrowthCurve::sprawl.
  void compareWith(std::span<const GrowthCurve> others, const StructurePrior& prior, FirstRegion& region) const;
  /// The noise in the units that bones are found in.
  Noise boneNoise(const Noise& noise) const;
  /// What a walk from a region's seed hardly leaves, where it is clearer than `other`, the region's clearest step.
  /// None beside bones and tubes, in a ball, and in Hounsfield units.
  std::optional<WalkRegion> clearerWalk(const FirstRegion& region, const StructurePrior& prior,
                                        const std::optional<ClearestStep>& other) const;
  /// Drops a bone's rim, and sets GrowthCurve::boneLead.
  void endAtRim(FirstRegion& region, int step, const StructurePrior& prior) const;
  /// Takes from a bone what its rim holds less than half of.
  std::vector<RimVoxel> dropRim(std::vector<Level>& joins, int step, const Noise& noise) const;
  /// The levels of a box for all voxels of the volume.
  std::vector<Level> allOf(const VoxelBox& box, std::span<const Level> levels) const;

  const Volume& volume_;
  const TissueTree& tissues_;
  const BoneTree* bones_;
  std::optional<RegionBall> ball_;
};

}  // namespace fenestra::segmentation
