#include "rendering/stages/RemovedStage.h"

#include <algorithm>

#include "rendering/stages/Images.h"

namespace fenestra {

RemovedStage::RemovedStage(StageList& list, const OpenedHits& opened, const StartStages& opening)
    : KeyedStage(list, Pass::RayStart), opened_(opened), opening_(opening) {
  owns(starts_, hole_, distances_, edits_, faces_);
}

RemovedPass::CutImages RemovedStage::cut(const Frame& frame) const {
  return {.rays = frame.other->rays,
          .hitPoints = opening_.opened.hits().image,
          .focusFilled = opening_.surface().image,
          .distances = opening_.distances.distances().image,
          .rayStart = opening_.starts.starts().image,
          .editMap = opening_.edits.edits().orNull(),
          .reach = frame.widths().x + frame.widths().y + 1.0};
}

bool RemovedStage::hasHoles(const Frame& frame) const {
  return !gpu().protectedLabels().any() && !frame.method.keepsRemoved();
}

double RemovedStage::shortestVoxelSide() const {
  const glm::dvec3 spacing = gpu().grid().spacing;
  return std::min({spacing.x, spacing.y, spacing.z});
}

void RemovedStage::begin(const Frame& frame, Steps& steps) {
  const glm::ivec2 size = frame.view().size;
  const Sight& other = *frame.other;
  const RemovedPass::CutImages opening = cut(frame);
  if (!isEdited()) edits_ = {};
  const RemovedKey key{.hits = opened_.hits().version,
                       .openingStarts = opening_.starts.starts().version,
                       .opening = {other.view.camera, other.view.size, other.view.pixelScale},
                       .widths = frame.widths(),
                       .strokes = *other.strokes,
                       .holes = hasHoles(frame)};
  update(frame.own, steps, key, {}, [&](Regions) {
    const RemovedPass::Outputs outputs{.rayStart = sized(starts_, gl::Format::R32F, size),
                                       .hole = sized(hole_, gl::Format::RG32F, size),
                                       .distances = sized(distances_, gl::Format::R32F, size),
                                       .editMap = isEdited() ? &sized(edits_, gl::Format::RG32F, size) : nullptr};
    pass_.run(steps, gpu().schedule(), frame.own.rays, opened_.hits().image, opening, key.holes, shortestVoxelSide(),
              sized(faces_, gl::Format::RGBA32F, other.rays.size()), outputs);
  });
}

void RemovedStage::addAlong(const RayFrame& rays, const gl::Texture& hits, const gl::Region& region, const Frame& frame,
                            Steps& steps, const RemovedPass::Outputs& outputs) {
  pass_.runParts(steps, gpu().schedule(), rays, hits, cut(frame), hasHoles(frame), shortestVoxelSide(), faces_, region,
                 outputs);
}

}  // namespace fenestra
