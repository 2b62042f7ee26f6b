#pragma once
// Walls inside the opening.

#include "rendering/stages/MaximumStage.h"
#include "rendering/stages/WallStage.h"

namespace fenestra {

class WallsInsideStage : public WallStage {
 public:
  WallsInsideStage(StageList& list, const MaximumStage& seen, const PictureStarts& starts)
      : WallStage(list, WallPlacement::Inside), seen_(seen), starts_(starts) {}
  void begin(const Frame& frame, Steps& steps) override {
    stand(frame, steps, seen_.layer(), Inside{.hits = starts_.hits(), .starts = starts_.starts()});
  }

 private:
  const MaximumStage& seen_;
  const PictureStarts& starts_;
};

}  // namespace fenestra
