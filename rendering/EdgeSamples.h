#pragma once
// Stages 1 and 4 to 7 along the rays between pixel centres that make edges smooth (rendering/scene/EdgeRays.h).

#include <deque>

#include "rendering/gl/Texture.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/passes/EdgePass.h"
#include "rendering/passes/FocusLayerPass.h"

namespace fenestra {

struct PassChain;

/// Of one chain of passes, whose own stages have run for the pixels' centres. Needs its context current.
class EdgeSamples {
 public:
  explicit EdgeSamples(const gl::SharedPrograms& programs) : edgePass_(programs), focusLayerPass_(programs) {}

  /// Adds the steps that find the edges in some regions of the picture.
  void find(PassChain& chain, Regions regions);
  /// Adds those that draw what find() found; waits for it.
  void draw(PassChain& chain);
  /// The picture with smooth edges; none before find().
  const gl::Texture& picture() const { return smoothed_; }
  /// Between pictures.
  std::size_t bytes() const;

 private:
  /// As many pixels are drawn at a time: what their rays take of the device's memory, some 25 MB, has a limit.
  static constexpr int mostPixels = 1 << 16;

  void addBatch(PassChain& chain, const Scatter& batch, glm::ivec2 size);
  void addStarts(PassChain& chain, const RayFrame& rays, const gl::Region& region, glm::ivec2 size);
  void addStartsApart(PassChain& chain, const RayFrame& rays, const gl::Region& region, glm::ivec2 size);
  /// The same of an exploded view, instead of addLayers().
  const gl::Texture& addExploded(PassChain& chain, const Scatter& batch, const gl::Region& region, glm::ivec2 size);
  /// The image that stage 7 leaves.
  const gl::Texture& addLayers(PassChain& chain, const RayFrame& rays, const gl::Region& region, glm::ivec2 size);

  EdgePass edgePass_;
  FocusLayerPass focusLayerPass_;
  std::deque<RayFrame> rays_;                                           ///< of each batch
  std::deque<std::vector<FocusLayerPass::ExplodedStretch>> stretches_;  ///< the same of an exploded view
  gl::Texture smoothed_;
  /// Images of the rays of a batch, while it is drawn; those that the scene does not use stay empty.
  struct Batch {
    gl::Texture hitPoints, editMap, rayStart, distances, hole, focusLayer, protectedLayer, contextLayer, silhouette,
        composed, exempted;
  };
  Batch batch_;
};

}  // namespace fenestra
