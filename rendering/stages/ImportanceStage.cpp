#include "rendering/stages/ImportanceStage.h"

#include "rendering/stages/Images.h"

namespace fenestra {

using Found = ImportanceKey::Found;

ImportanceStage::ImportanceStage(StageList& list, Eye eye, const HitStage& hits)
    : KeyedStage(list, Pass::Importance), eye_(eye), hits_(hits) {
  owns(levels_, opened_);
}

bool ImportanceStage::isUsed(const Frame& frame) const {
  return frame.hasCutaway && (eye_ == Eye::Picture || frame.other) && !gpu().importance().empty();
}

Found ImportanceStage::foundIn(const Frame& frame) const {
  if (!frame.isCutFor(eye_)) return Found::Topmost;
  return frame.method.start == MethodStages::Start::Cones ? Found::Cones : Found::Surfaces;
}

void ImportanceStage::begin(const Frame& frame, Steps& steps) {
  const Sight& sight = frame.sight(eye_);
  const std::vector<KeptLabels>& labels = gpu().importance();
  const Found found = foundIn(frame);
  levels_.resize(found == Found::Cones ? labels.size() : 0);
  if (found == Found::Cones) opened_ = {};
  update(sight, steps, {.hits = hits_.hits().version, .found = found}, {}, [&](Regions) {
    const gl::Texture& hits = hits_.hits().image;
    const auto image = [&](gl::Texture& made) -> gl::Texture& {
      return sized(made, gl::Format::RG32F, sight.rays.size());
    };
    if (found == Found::Topmost) {
      pass_.run(steps, gpu(), labels.back(), sight.rays, hits, image(opened_));
      return;
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (found == Found::Cones)
        pass_.run(steps, gpu(), labels[i], sight.rays, hits, image(levels_[i]));
      else
        pass_.run(steps, gpu(), labels[i], sight.rays, hits, image(opened_), i > 0);
    }
  });
}

}  // namespace fenestra
