#include "rendering/stages/RayStartStage.h"

#include <algorithm>

#include "rendering/stages/Images.h"

namespace fenestra {

RayStartStage::RayStartStage(StageList& list, Eye eye, const StartInputs& inputs, const EditStage& edits)
    : KeyedStage(list, Pass::RayStart), eye_(eye), inputs_(inputs), edits_(edits) {
  owns(starts_);
}

void RayStartStage::release() {
  KeyedStage::release();
  moved_.reset();
}

void RayStartStage::begin(const Frame& frame, Steps& steps) {
  const Sight& sight = frame.sight(eye_);
  const StartKey key = inputs_.key(sight);
  const auto& last = lastKey();
  moved_.reset();
  // Cones reach as far as they like.
  if (last && last->hits == key.hits && last->cones == Version{} && key.cones == Version{})
    moved_ = {.before = version(), .reach = std::max(last->openWidth, key.openWidth) + 1.0};
  update(sight, steps, key,
         {.part = moved_ ? nearFocus(gpu(), sight, moved_->reach) : std::nullopt, .changed = changedStrokes(sight)},
         [&](Regions regions) {
           pass_.run(steps, gpu().schedule(), sight.rays, inputs_.of(sight), edits_.edits().orNull(), regions,
                     sized(starts_, gl::Format::R32F, sight.view.size));
         });
}

}  // namespace fenestra
