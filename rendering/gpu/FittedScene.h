#pragma once
// A scene at the resolution that the device can hold: the scene itself, or its voxels thinned by whole factors where
// the volume exceeds the longest side of a 3-D texture or the graphics memory.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "rendering/scene/Scene.h"

namespace fenestra {

struct DeviceLimits {
  int side = 0;                      ///< of a 3-D texture, in texels
  std::optional<std::size_t> bytes;  ///< for a scene's voxels; unknown: until an allocation fails
};
/// Limits of the current context. Its driver says how much memory is free; where the CPU draws, the limit is half of
/// the main memory.
DeviceLimits deviceLimits();

/// Bytes that a volume takes on the device when each voxel stands for `factor` voxels: texture, gradients (all of
/// them, when lit), derivatives and bricks.
std::size_t deviceBytes(const Scene& scene, glm::ivec3 factor);
/// The least factors that keep within `limits`. Along the axis with the finest spacing first, so that voxels become
/// more alike in their sides.
glm::ivec3 fittingFactor(const Scene& scene, const DeviceLimits& limits);

class FittedScene {
 public:
  /// Whether `scene` shows another volume, or other parts of it, than what was fitted last.
  bool isOfOther(const Scene& scene) const { return shownVolume(scene) != source_; }
  /// Takes a new volume. Nothing is thinned yet.
  void take(const Scene& scene, const DeviceLimits& limits);
  /// Thins further, after an allocation failed. False when the volume is small already.
  bool coarsen();

  /// `scene`, of the volume taken last, with the voxels to draw. Thins them on the first call.
  Scene of(const Scene& scene);
  /// Voxels along each axis that one drawn voxel stands for.
  glm::ivec3 factor() const { return factor_; }

 private:
  ShownVolume source_;
  std::shared_ptr<const Volume> volume_;  ///< thinned
  /// Thinned label maps: those that hold the focus, and those that have roles.
  struct Labels {
    std::shared_ptr<const LabelMap> source, thinned;
  } labels_, structures_;
  const std::shared_ptr<const LabelMap>& thinnedOnce(Labels& labels, const std::shared_ptr<const LabelMap>& source);
  glm::ivec3 factor_{1};
};

}  // namespace fenestra
