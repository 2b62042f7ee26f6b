#pragma once
// Stage 4 where another camera than the picture's cuts the opening: what that opening removes of the picture's rays.

#include "rendering/passes/RemovedPass.h"
#include "rendering/stages/StartStages.h"

namespace fenestra {

struct RemovedKey {
  Version hits;           ///< the picture's
  Version openingStarts;  ///< those of the camera that cuts the opening
  OpeningView opening;
  glm::dvec2 widths;
  ProjectedStrokes strokes;
  bool holes;
  bool operator==(const RemovedKey&) const = default;
};

class RemovedStage : public KeyedStage<RemovedKey> {
 public:
  /// `opened`: of the picture's camera. `opening`: the stages of the camera that cuts the opening.
  RemovedStage(StageList& list, const OpenedHits& opened, const StartStages& opening);
  bool isUsed(const Frame& frame) const override { return frame.other.has_value(); }
  void begin(const Frame& frame, Steps& steps) override;

  // RemovedPass::Outputs.
  Output starts() const { return {starts_, version()}; }
  Output hole() const { return {hole_, version()}; }
  Output distances() const { return {distances_, version()}; }
  Output edits() const { return {edits_, version()}; }  ///< none without strokes

  /// Adds the same for other rays of the picture, in a part of their images, once the stage is done.
  void addAlong(const RayFrame& rays, const gl::Texture& hits, const gl::Region& region, const Frame& frame,
                Steps& steps, const RemovedPass::Outputs& outputs);
  /// Whether strokes edit the opening, so that those outputs need an edit map.
  bool isEdited() const { return static_cast<bool>(opening_.edits.edits()); }

 private:
  RemovedPass::CutImages cut(const Frame& frame) const;
  bool hasHoles(const Frame& frame) const;
  double shortestVoxelSide() const;

  const OpenedHits& opened_;
  const StartStages& opening_;
  RemovedPass pass_{gpu().programs()};
  gl::Texture starts_, hole_, distances_, edits_;
  gl::Texture faces_;  ///< RGBA32F, between the two parts of the pass
};

}  // namespace fenestra
