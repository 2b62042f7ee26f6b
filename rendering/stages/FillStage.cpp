#include "rendering/stages/FillStage.h"

#include "rendering/stages/Images.h"

namespace fenestra {

FillStage::FillStage(StageList& list, Eye eye, const OpenedHits& opened)
    : KeyedStage(list, Pass::PullPush), eye_(eye), opened_(opened) {
  owns(filled_, pass_);
}

bool FillStage::isUsed(const Frame& frame) const {
  return frame.isCutFor(eye_) && frame.method.start != MethodStages::Start::Cones;
}

void FillStage::begin(const Frame& frame, Steps& steps) {
  const Sight& sight = frame.sight(eye_);
  const Output hits = opened_.hits();
  update(sight, steps, {.hits = hits.version}, {}, [&](Regions) {
    pass_.run(steps, gpu().schedule(), hits.image, sized(filled_, gl::Format::R32F, sight.rays.size()));
  });
}

}  // namespace fenestra
