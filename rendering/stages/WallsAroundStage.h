#pragma once
// Walls around the volume.

#include "rendering/stages/ExemptStage.h"

namespace fenestra {

class WallsAroundStage : public WallStage {
 public:
  WallsAroundStage(StageList& list, const MaximumStage& seen, const CompositeStage& composite,
                   const ExemptStage& exempt)
      : WallStage(list, WallPlacement::Around), seen_(seen), composite_(composite), exempt_(exempt) {}
  void begin(const Frame& frame, Steps& steps) override {
    stand(frame, steps, firstOf({exempt_.picture(), composite_.picture(), seen_.layer()}), std::nullopt);
  }

 private:
  const MaximumStage& seen_;
  const CompositeStage& composite_;
  const ExemptStage& exempt_;
};

}  // namespace fenestra
