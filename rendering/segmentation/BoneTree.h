#pragma once
// The bones of a CT, parted where they meet in necks.
//
// Two bones that touch are joined by less than either is thick: by a facet, a costal joint. Between them lies
// cartilage, which the scanner blurs to a bridge that is dense enough for bone, but darker than the bone on both sides.
// So the dense voxels (BoneVoxels.h) are parted into the basins of their depth, a watershed, and the basins merge two
// by two, as the tissues of TissueTree.h do, those with the widest neck and the least gap first. Two parts merge at the
// cost
//
//   neckUnit · (1 / width - 1 + gapWeight · gap), width: the greatest depth of their common border ÷ the lesser of
//   their greatest depths; gap: the share of the bone's density that the border lacks (BoneJoints.h)
//
// The width is 1 where the border is half a voxel less deep than the lesser part at most. Necks alone took the thin
// middle of a hip bone for a joint, and the hip joint, whose surfaces touch widely, for none. The program's own
// formula.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "rendering/segmentation/HounsfieldGuess.h"
#include "rendering/segmentation/Levels.h"
#include "rendering/segmentation/MergeTree.h"
#include "rendering/segmentation/Smoothing.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/segmentation/VoxelSet.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

class BoneTree {
 public:
  /// `volume` has fewer than 2³² voxels. Where it is a CT in other units than Hounsfield's, `guess` tells of
  /// these, as hounsfieldGuess() finds it, and the tree holds a copy of the volume in them. `goOn` is asked now and
  /// then; null when it returned false, and where the volume is no CT. Takes up to three bytes a voxel while it runs,
  /// and some 40 for each dense one. Deterministic.
  static std::shared_ptr<const BoneTree> build(const Volume& volume, const std::optional<HounsfieldGuess>& guess,
                                               const std::function<bool()>& goOn = {});

  /// Whether joinsOf() could find a bone at a seed. Needs no tree, and little time. False where the volume is no CT.
  static bool isNear(const Volume& volume, const std::optional<HounsfieldGuess>& guess, glm::ivec3 seed);

  /// The volume that the tree was built of, in Hounsfield units: `volume` itself where it is.
  const Volume& inUnits(const Volume& volume) const { return scaled_ ? *scaled_ : volume; }

  /// The levels at which voxels join the bone at a seed, which need not be dense itself: that of the least merge which
  /// holds the bone nearest to the seed and the voxel. Regions of all levels are closed with a ball of two voxels, so
  /// that they hold their marrow; what does not hold the seed is no region. Entry i is of voxel i of the volume. Empty
  /// where no bone holds the seed, which costs next to nothing far from bone. Runs on all cores.
  std::optional<std::vector<Level>> joinsOf(glm::ivec3 seed) const;

  /// The last step of joinsOf() that crosses no joint: a larger region is several bones.
  static int lastStep();
  /// Whether the dense voxels of a region of joinsOf() are as uneven as bone is. Contrast agent makes blood and organs
  /// as dense, but even.
  bool isBone(const Volume& volume, std::span<const Level> joins, int step) const;

  std::size_t heldBytes() const;

 private:
  static constexpr std::uint32_t none = MergeTree::none;

  std::uint32_t leafNear(glm::ivec3 seed) const;

  Grid grid_;
  std::shared_ptr<const Volume> scaled_;  ///< null where the volume is in Hounsfield units
  Noise noise_;                           ///< HU
  VoxelSet voxels_;
  std::vector<std::uint32_t> leaves_;  ///< by voxel of the set
  MergeTree merges_;
};

}  // namespace fenestra::segmentation
