#pragma once
// Walls inside the opening.

#include "rendering/stages/FocusLayerStage.h"
#include "rendering/stages/WallStage.h"

namespace fenestra {

class WallsInsideStage : public WallStage {
 public:
  WallsInsideStage(StageList& list, const FocusLayerStage& focusLayer, const PictureStarts& starts)
      : WallStage(list, WallPlacement::Inside), focusLayer_(focusLayer), starts_(starts) {}
  void begin(const Frame& frame, Steps& steps) override {
    stand(frame, steps, focusLayer_.layer(), Inside{.hits = starts_.hits(), .starts = starts_.starts()});
  }

 private:
  const FocusLayerStage& focusLayer_;
  const PictureStarts& starts_;
};

}  // namespace fenestra
