#pragma once
// Smooth edges (rendering/scene/EdgeRays.h): what the rays between pixel centres see. Stages 1 and 4 to 7 run again for
// them, on images of their own.

#include <deque>
#include <vector>

#include "rendering/stages/EdgeStage.h"

namespace fenestra {

struct EdgeRayKey {
  Version found;
  bool operator==(const EdgeRayKey&) const = default;
};

class EdgeRayStage : public KeyedStage<EdgeRayKey> {
 public:
  /// The stages that have run for the pixels' centres.
  struct Inputs {
    EdgeStage& edges;  ///< whose picture is blended into
    const StartStages& own;
    RemovedStage& removed;
    const PictureStarts& starts;
    const OcclusionStage& occlusion;
    const ProtectedLayerStage& protectedLabels;
    const ContextLinesStage& lines;
  };
  EdgeRayStage(StageList& list, const Inputs& inputs);
  bool isUsed(const Frame& frame) const override { return inputs_.edges.isUsed(frame); }
  void begin(const Frame& frame, Steps& steps) override;

 private:
  /// So many pixels are drawn at a time: what their rays take of the device's memory, some 25 MB, has a limit.
  static constexpr int mostPixels = 1 << 16;

  /// A part of the list of pixels and the rays through them.
  struct Batch {
    Scatter pixels;
    gl::Region region;  ///< in images of `size`
    glm::ivec2 size;
    const RayFrame& rays;
  };
  void draw(const Frame& frame, Steps& steps);
  void addStarts(const Frame& frame, Steps& steps, const Batch& batch);
  void addStartsApart(const Frame& frame, Steps& steps, const Batch& batch);
  void addFocusLayer(const Frame& frame, Steps& steps, const Batch& batch);
  void addExploded(const Frame& frame, Steps& steps, const Batch& batch);
  void addComposite(const Frame& frame, Steps& steps, const Batch& batch);
  /// Adds stages 5 to 7; returns the image that they leave.
  const gl::Texture& addLayers(const Frame& frame, Steps& steps, const Batch& batch);

  Inputs inputs_;
  HitPointPass hitPointPass_{gpu().programs()};
  EditMapPass editMapPass_{gpu().programs()};
  RayStartPass rayStartPass_{gpu().programs()};
  FocusLayerPass focusLayerPass_{gpu().programs()};
  ProtectedLayerPass protectedLayerPass_{gpu().programs()};
  ContextLayerPass contextLayerPass_{gpu().programs()};
  CompositePass compositePass_{gpu().programs()};
  ExemptPass exemptPass_{gpu().programs()};
  std::deque<RayFrame> rays_;                                           ///< those of one batch each
  std::deque<std::vector<FocusLayerPass::ExplodedStretch>> stretches_;  ///< one list a batch, in an exploded view
  /// Images of the rays of a batch, while it is drawn; those that the scene does not use stay empty.
  gl::Texture hits_, edits_, starts_, distances_, hole_, focusLayer_, protectedLayer_, contextLayer_, silhouette_,
      composed_, exempted_;
};

}  // namespace fenestra
