#pragma once
// What stays of that which the opening removes, in front of the focus layer: labels that are protected, or all of it,
// for methods that keep it faint.

#include "rendering/passes/ProtectedLayerPass.h"
#include "rendering/stages/OcclusionStage.h"
#include "rendering/stages/PictureStarts.h"

namespace fenestra {

struct KeptLayerKey {
  /// How the focus looks, where some of it is removed.
  struct FocusLook {
    std::uint64_t focus, palette;
    double extinction;
    bool operator==(const FocusLook&) const = default;
  };
  Version starts;
  Version occlusion;                                          ///< none without ambient occlusion and shadows
  std::uint64_t volume, protectedLabels, transfer, gradient;  ///< versions of the scene on the GPU
  Shading shading;
  FocusLayerPass::Sampling sampling;
  std::optional<FocusLook> removedFocus;
  bool operator==(const KeptLayerKey&) const = default;
};

/// What both have in common.
class KeptLayerStage : public KeyedStage<KeptLayerKey> {
 public:
  /// Premultiplied RGBA32F.
  Output layer() const { return {layer_, version()}; }

 protected:
  KeptLayerStage(StageList& list, Pass pass, const PictureStarts& starts, const OcclusionStage& occlusion);
  /// Without what only one of them depends on.
  KeptLayerKey keyOf(const Frame& frame) const;
  void draw(const Frame& frame, Steps& steps, const KeptLayerKey& key, ProtectedLayerPass::Shown shown);

 private:
  const PictureStarts& starts_;
  const OcclusionStage& occlusion_;
  ProtectedLayerPass pass_{gpu().programs()};
  gl::Texture layer_;
};

/// All that is removed.
class FaintLayerStage : public KeptLayerStage {
 public:
  FaintLayerStage(StageList& list, const PictureStarts& starts, const OcclusionStage& occlusion)
      : KeptLayerStage(list, Pass::FaintLayer, starts, occlusion) {}
  bool isUsed(const Frame& frame) const override { return frame.method.keepsRemoved(); }
  void begin(const Frame& frame, Steps& steps) override;
};

class ProtectedLayerStage : public KeptLayerStage {
 public:
  ProtectedLayerStage(StageList& list, const PictureStarts& starts, const OcclusionStage& occlusion)
      : KeptLayerStage(list, Pass::ProtectedLayer, starts, occlusion) {}
  bool isUsed(const Frame& frame) const override { return frame.hasCutaway && gpu().protectedLabels().any(); }
  void begin(const Frame& frame, Steps& steps) override;
};

}  // namespace fenestra
