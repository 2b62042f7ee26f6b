#pragma once
// What regions of one volume share, so that a correction need not begin anew.

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "rendering/segmentation/BoneRim.h"
#include "rendering/segmentation/BoneTree.h"
#include "rendering/segmentation/Curve.h"
#include "rendering/segmentation/HounsfieldGuess.h"
#include "rendering/segmentation/Smoothing.h"
#include "rendering/segmentation/TissueTree.h"

namespace fenestra::segmentation {

/// The region of a first seed in the whole volume, before further seeds change it.
struct FirstRegion {
  glm::ivec3 seed{0};
  glm::dvec3 centre{0.0};  ///< of the ball, world mm
  double ball = 0.0;       ///< as RegionFocus::ball
  std::vector<Level> joins, costs;
  Noise noise;
  GrowthCurve curve;
  bool isBone = false;        ///< whether it is one of BoneTree's
  std::vector<RimVoxel> rim;  ///< what was dropped from the bone
  bool isTube = false;        ///< whether it is one of TubeTracer.h's
  bool isWalk = false;        ///< whether it is one of RandomWalk.h's
};

/// A handle; copies share what it holds, some three bytes a voxel, and the volume's tissues and bones. growRegion()
/// reads it and adds to it, on one thread at a time.
class GrowthMemory {
 public:
  GrowthMemory(std::shared_ptr<const TissueTree> tissues = nullptr)
      : held_(std::make_shared<Held>(Held{std::move(tissues), nullptr, nullptr, std::nullopt})) {}

  std::shared_ptr<const TissueTree>& tissues() const { return held_->tissues; }
  /// Null where the volume is no CT, and until a seed is near a bone.
  std::shared_ptr<const BoneTree>& bones() const { return held_->bones; }
  std::shared_ptr<const FirstRegion>& first() const { return held_->first; }
  /// hounsfieldGuess() of the memory's volume, which is asked once.
  const std::optional<HounsfieldGuess>& guessOf(const Volume& volume) const {
    if (!held_->guess) held_->guess = hounsfieldGuess(volume);
    return *held_->guess;
  }
  std::size_t bytes() const {
    return (held_->tissues ? held_->tissues->heldBytes() : 0) + (held_->bones ? held_->bones->heldBytes() : 0) +
           (held_->first ? held_->first->joins.size() + held_->first->costs.size() : 0);
  }

 private:
  struct Held {
    std::shared_ptr<const TissueTree> tissues;
    std::shared_ptr<const BoneTree> bones;
    std::shared_ptr<const FirstRegion> first;
    std::optional<std::optional<HounsfieldGuess>> guess;
  };
  std::shared_ptr<Held> held_;
};

}  // namespace fenestra::segmentation
