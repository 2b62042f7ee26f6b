#pragma once
// Stage 7: the picture of an opening from its layers.

#include "rendering/passes/CompositePass.h"
#include "rendering/stages/ContextLinesStage.h"
#include "rendering/stages/KeptLayerStages.h"
#include "rendering/stages/LensStage.h"
#include "rendering/stages/WallsInsideStage.h"

namespace fenestra {

struct CompositeKey {
  Version focusLayer, walls;  ///< walls inside the opening
  Version distances;
  Version contextLayer, protectedLayer, faintLayer, lens;  ///< none for what the picture does not have
  std::optional<std::uint64_t> ownColours;                 ///< the transfer functions' version, with a context layer
  MethodStages method;
  glm::dvec2 widths;
  glm::dvec3 borderColour;
  ContextLayer look;
  double leastLine;
  bool operator==(const CompositeKey&) const = default;

  /// Whether both lay something over the same picture.
  bool hasSameBelow(const CompositeKey& other) const {
    return focusLayer == other.focusLayer && distances == other.distances && contextLayer == other.contextLayer &&
           protectedLayer == other.protectedLayer && faintLayer == other.faintLayer && lens == other.lens &&
           walls == other.walls && method == other.method;
  }
  double reach() const { return widths.x + widths.y + 1.0; }  ///< rendered pixels around the focus, its rim included
};

class CompositeStage : public KeyedStage<CompositeKey> {
 public:
  /// The layers that it reads.
  struct Layers {
    const PictureStarts& starts;
    const MaximumStage& seen;  ///< what rays see from their starts on
    const WallsInsideStage& walls;
    const FaintLayerStage& faint;
    const ProtectedLayerStage& protectedLabels;
    const ContextLayerStage& context;
    const ContextLinesStage& lines;
    const LensStage& lens;
  };
  CompositeStage(StageList& list, const Layers& layers);
  bool isUsed(const Frame& frame) const override { return frame.hasCutaway; }
  void begin(const Frame& frame, Steps& steps) override;

  /// Premultiplied RGBA32F.
  Output picture() const { return {picture_, version()}; }

 private:
  /// What the layers are laid over.
  Output below() const { return firstOf({layers_.walls.picture(), layers_.seen.layer()}); }
  CompositeKey keyOf(const Frame& frame) const;
  CompositePass::Inputs inputs(const Frame& frame) const;
  /// What of the picture differs from the one before; empty: any of it may.
  std::optional<gl::Region> changedPart(const Frame& frame, const CompositeKey& key) const;

  Layers layers_;
  CompositePass pass_{gpu().programs()};
  gl::Texture picture_;
};

}  // namespace fenestra
