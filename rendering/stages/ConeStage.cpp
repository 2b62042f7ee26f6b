#include "rendering/stages/ConeStage.h"

#include "rendering/stages/Images.h"

namespace fenestra {

ConeStage::ConeStage(StageList& list, Eye eye, const HitStage& hits, const ImportanceStage& levels)
    : KeyedStage(list, Pass::Cones), eye_(eye), hits_(hits), levels_(levels) {
  owns(starts_, opened_, pass_);
}

bool ConeStage::isUsed(const Frame& frame) const {
  return frame.isCutFor(eye_) && frame.method.start == MethodStages::Start::Cones;
}

void ConeStage::begin(const Frame& frame, Steps& steps) {
  const Sight& sight = frame.sight(eye_);
  const ConePass::Cones cones{.slope = frame.method.slope, .onSilhouette = frame.method.onSilhouette};
  const std::vector<gl::Texture>& levels = levels_.levels();
  if (levels.empty()) opened_ = {};
  const ConeKey key{.hits = hits_.hits().version, .levels = levels_.levelsVersion(), .cones = cones};
  update(sight, steps, key, {}, [&](Regions) {
    const gl::Region around = nearFocus(gpu(), sight, 1.0).value_or(gl::Region());
    const Schedule schedule = gpu().schedule();
    gl::Texture& starts = sized(starts_, gl::Format::R32F, sight.rays.size());
    if (levels.empty()) pass_.run(steps, schedule, sight.rays, hits_.hits().image, around, cones, starts);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      gl::Texture& opened = sized(opened_, gl::Format::RG32F, sight.rays.size());
      pass_.run(steps, schedule, sight.rays, levels[i], around, cones, starts, ConePass::Level{opened, i == 0});
    }
  });
}

}  // namespace fenestra
