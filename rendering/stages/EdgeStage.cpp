#include "rendering/stages/EdgeStage.h"

#include "rendering/scene/Edges.h"
#include "rendering/stages/Images.h"

namespace fenestra {

EdgeStage::EdgeStage(StageList& list, const PixelPicture& pixels, const HitStage& hits, const PictureStarts& starts)
    : KeyedStage(list, Pass::Edges), pixels_(pixels), hits_(hits), starts_(starts) {
  owns(smoothed_, pass_);
}

bool EdgeStage::isUsed(const Frame& frame) const { return hasSmoothEdges(frame.look(), frame.view()); }

void EdgeStage::begin(const Frame& frame, Steps& steps) {
  // A pixel's contrast depends on those beside it, and its rays reach over its rim.
  constexpr int margin = 2;
  std::vector<gl::Region> changed;
  for (const gl::Region& region : changedStrokes(frame.own))
    changed.push_back(grown(region, margin, frame.view().size));
  // A list of the changed pixels would replace one of which a part is not drawn yet.
  if (!changed.empty() && !isBlended_) forget();
  const Output picture = pixels_.picture();
  update(frame.own, steps, {.picture = picture.version}, {.changed = changed}, [&](Regions regions) {
    std::optional<EdgePass::OpeningRim> opening;
    if (frame.hasCutaway)
      opening.emplace(EdgePass::OpeningRim{
          .hitPoints = hits_.hits().image, .distances = starts_.distances().image, .widths = frame.widths()});
    isBlended_ = false;
    pass_.find(steps, gpu().schedule(), picture.image, opening, regions,
               sized(smoothed_, gl::Format::RGBA32F, glm::ivec2(picture.image.size()), presented));
    steps.then([this] { found_ = newVersion(); });
  });
}

void EdgeStage::blend(Steps& steps, const Scatter& batch, const gl::Texture& drawn) {
  pass_.blend(steps, gpu().schedule(), batch, pixels_.picture().image, drawn, smoothed_);
}

}  // namespace fenestra
