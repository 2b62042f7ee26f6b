#pragma once
// The greatest value of the context along each ray, beneath the focus layer.

#include "rendering/passes/MaximumPass.h"
#include "rendering/stages/FocusLayerStage.h"

namespace fenestra {

struct MaximumKey {
  Version focusLayer;
  Version starts;                         ///< none without a cutaway
  std::uint64_t volume, focus, transfer;  ///< versions of the scene on the GPU
  MethodStages::Maximum maximum;
  Camera camera;
  glm::ivec2 size;
  Clip clip;
  bool operator==(const MaximumKey&) const = default;
};

class MaximumStage : public KeyedStage<MaximumKey> {
 public:
  MaximumStage(StageList& list, const FocusLayerStage& focusLayer, const PictureStarts& starts);
  bool isUsed(const Frame& frame) const override;
  void begin(const Frame& frame, Steps& steps) override;

  /// Premultiplied RGBA32F: the focus layer, with the context behind it where the picture shows that by its greatest
  /// value.
  Output layer() const { return firstOf({Output{picture_, version()}, focusLayer_.layer()}); }

 private:
  const FocusLayerStage& focusLayer_;
  const PictureStarts& starts_;
  MaximumPass pass_{gpu().programs()};
  gl::Texture picture_;
};

}  // namespace fenestra
