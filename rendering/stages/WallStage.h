#pragma once
// Slices that stand in the picture as walls (rendering/scene/Walls.h). They have two places in the chain: inside the
// opening they are laid over the focus layer, around the volume beneath the picture.

#include "rendering/passes/WallPass.h"
#include "rendering/stages/KeyedStage.h"

namespace fenestra {

struct WallKey {
  Version below;   ///< what they are laid over or beneath
  Version starts;  ///< none around the volume
  MethodStages::Walls walls;
  ShownSlices slices;
  std::shared_ptr<const Volume> volume;
  std::shared_ptr<const LabelMap> labels, structures;  ///< null without outlines
  LabelSettings settings;
  Camera camera;
  glm::ivec2 size;
  bool operator==(const WallKey&) const = default;
};

/// What the stages of both places have in common.
class WallStage : public KeyedStage<WallKey> {
 public:
  bool isUsed(const Frame& frame) const override;

  Output layer() const { return {layer_, version()}; }      ///< premultiplied RGBA32F: the walls alone
  Output picture() const { return {picture_, version()}; }  ///< premultiplied RGBA32F: with what they are laid over

 protected:
  WallStage(StageList& list, WallPlacement placement);
  /// Where rays meet and start inside the opening.
  struct Inside {
    Output hits, starts;
  };
  void stand(const Frame& frame, Steps& steps, const Output& below, const std::optional<Inside>& inside);

 private:
  WallPlacement placement_;
  WallPass pass_{gpu().programs()};
  gl::Texture layer_, picture_;
};

}  // namespace fenestra
