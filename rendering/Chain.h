#pragma once
// The stages of a picture, and the walk over them that draws one.

#include <memory>
#include <optional>

#include "rendering/stages/EdgeRayStage.h"

namespace fenestra {

/// All stages, in the order in which they are begun. Each names the earlier ones that it reads.
struct PictureStages {
  explicit PictureStages(std::shared_ptr<GpuScene> gpu) : list(std::move(gpu)) {}

  StageList list;
  StartStages opening{list, Eye::Opening};
  StartStages own{list, Eye::Picture};
  RemovedStage removed{list, own.opened, opening};
  PictureStarts starts{own, removed};
  OcclusionStage occlusion{list, own, opening};
  FocusLayerStage focusLayer{list, own, starts, occlusion};
  MaximumStage maximum{list, focusLayer, starts};
  FaintLayerStage faintLayer{list, starts, occlusion};
  ProtectedLayerStage protectedLayer{list, starts, occlusion};
  ContextLayerStage contextLayer{list, starts};
  ContextLinesStage lines{list, starts, contextLayer};
  LensStage lens{list, starts};
  WallsInsideStage wallsInside{list, maximum, starts};
  CompositeStage composite{list, {starts, maximum, wallsInside, faintLayer, protectedLayer, contextLayer, lines, lens}};
  ExemptStage exempt{list, maximum, composite, occlusion};
  WallsAroundStage wallsAround{list, maximum, composite, exempt};
  PixelPicture pixels{maximum, composite, exempt, wallsAround};
  EdgeStage edges{list, pixels, own.hits, starts};
  EdgeRayStage edgeRays{list, {edges, own, removed, starts, occlusion, protectedLayer, lines}};
};

/// Keeps each stage's images from one picture to the next. Needs a current context.
class Chain {
 public:
  explicit Chain(std::shared_ptr<GpuScene> gpu) : stages_(std::move(gpu)) {}

  /// Begins a picture; drops the one under way.
  void begin(const Scene& scene, const View& view);
  /// Runs what the picture under way needs, for about so many milliseconds, or without a limit; true when it is done.
  bool advance(std::optional<double> milliseconds);
  bool isDrawing() const { return isDrawing_; }
  void drop();

  /// The picture begun last; null before the first.
  const Frame* frame() const { return frame_ ? &*frame_ : nullptr; }
  const PictureStages& stages() const { return stages_; }
  GpuScene& gpu() const { return stages_.list.gpu(); }
  /// Premultiplied RGBA32F without background; empty before the first picture.
  const gl::Texture& picture() const;

  void setTiming(bool on) { stages_.list.timing = on; }

 private:
  void beginAsDrawn(const Scene& scene, const View& view, std::shared_ptr<const PeeledScene> peeled);
  /// Begins the next stage that the picture needs, and releases those before it that it does not.
  void beginStage();
  void end();

  PictureStages stages_;
  std::optional<Frame> frame_;
  bool isDrawing_ = false;
  std::size_t begun_ = 0;  ///< stages of the list
  Steps steps_;            ///< what the stage begun last has still to do
};

}  // namespace fenestra
