#include "rendering/stages/EditStage.h"

#include "rendering/stages/Images.h"

namespace fenestra {

EditStage::EditStage(StageList& list, Eye eye, const StartInputs& inputs)
    : KeyedStage(list, Pass::EditMap), eye_(eye), inputs_(inputs) {
  owns(edits_, pass_);
}

bool EditStage::isUsed(const Frame& frame) const { return frame.isCutFor(eye_) && !frame.sight(eye_).strokes->empty(); }

void EditStage::begin(const Frame& frame, Steps& steps) {
  const Sight& sight = frame.sight(eye_);
  update(sight, steps, inputs_.key(sight), {.changed = changedStrokes(sight)}, [&](Regions regions) {
    pass_.run(steps, gpu().schedule(), sight.rays, inputs_.of(sight), *sight.strokes, regions,
              sized(edits_, gl::Format::RG32F, sight.view.size));
  });
}

}  // namespace fenestra
