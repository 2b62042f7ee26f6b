#pragma once
// A focus as GPU objects. Those of a label focus follow its labels: what joins or leaves costs what changes by it.

#include <cstdint>
#include <optional>
#include <vector>

#include "rendering/gl/Buffer.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/Bricks.h"
#include "rendering/gpu/FocusIndex.h"
#include "rendering/gpu/FocusSmooth.h"
#include "rendering/gpu/LabelIndex.h"
#include "rendering/scene/Scene.h"

namespace fenestra {

/// Needs a current context.
class GpuFocus {
 public:
  /// Bricks by whether some of the focus lies in them.
  struct Change {
    bool isNew = false;                ///< all may differ from before
    std::vector<std::size_t> flipped;  ///< otherwise: offsets of those that hold some now or hold none any more
  };
  /// Brings index, bricks and cells up to date. `bricks` are the volume's.
  Change update(const Scene& scene, const BrickRanges& bricks);
  /// Makes what shading needs of a label focus, or drops it.
  void updateSmooth(bool wanted);
  void release();

  const FocusIndex& index() const { return index_; }
  /// As shaders/lib/focus/Index.glsl reads them.
  const gl::Texture& bricks() const { return bricks_; }
  const gl::Buffer& cells() const { return cells_; }
  /// Smoothed indicator, see FocusSmooth; only where it was asked for.
  const gl::Texture& smooth() const { return smooth_; }
  glm::ivec3 smoothOrigin() const { return smoothBox_.origin; }  ///< index of its first texel

 private:
  void uploadCells();
  /// Filters the tiles and uploads them.
  void uploadSmooth(const FocusSmooth& source, const std::vector<glm::ivec3>& tiles);

  FocusIndex index_;
  std::optional<LabelIndexer> indexer_;
  gl::Texture bricks_;
  gl::Buffer cells_;
  LabelSmoothing smoothing_ = LabelSmoothing::Off;  ///< of the labels in `cells_`
  gl::Texture smooth_;
  SmoothBox smoothBox_;
  std::shared_ptr<const SmoothedIndicator> smoothOf_;  ///< what it was made of, where that is one
  std::vector<std::size_t> stale_;                     ///< bricks that have changed since smooth_ was made
};

}  // namespace fenestra
