#include "rendering/stages/HitStage.h"

#include "rendering/stages/Images.h"

namespace fenestra {

HitStage::HitStage(StageList& list, Eye eye) : KeyedStage(list, Pass::HitPoints), eye_(eye) { owns(hits_); }

bool HitStage::isUsed(const Frame& frame) const {
  return eye_ == Eye::Opening ? frame.other.has_value() : frame.hasCutaway || frame.explodesAroundFocus();
}

void HitStage::begin(const Frame& frame, Steps& steps) {
  const Sight& sight = frame.sight(eye_);
  const GpuScene::Versions& scene = gpu().versions();
  const HitKey key{.volume = scene.volume,
                   .focus = scene.focus,
                   .gaps = scene.gaps,
                   .importance = scene.importance,
                   .camera = sight.view.camera,
                   .size = sight.view.size,
                   .clip = sight.rays.clip()};
  update(sight, steps, key, {},
         [&](Regions) { pass_.run(steps, gpu(), sight.rays, sized(hits_, gl::Format::RG32F, sight.view.size)); });
}

}  // namespace fenestra
