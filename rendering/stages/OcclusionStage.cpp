#include "rendering/stages/OcclusionStage.h"

#include "rendering/scene/Lighting.h"

namespace fenestra {

OcclusionStage::OcclusionStage(StageList& list, const StartStages& own, const StartStages& other)
    : KeyedStage(list, Pass::Occlusion), own_(own), other_(other) {
  owns(nodes_, pass_);
}

void OcclusionStage::begin(const Frame& frame, Steps& steps) {
  const Sight& cutting = frame.cutting();
  // A stroke changes what casts shadows all around it.
  if (!changedStrokes(cutting).empty()) forget();
  const Shading& shading = frame.look().shading;
  const StartStages& cuts = frame.other ? other_ : own_;
  const bool open = frame.hasCutaway;
  OcclusionKey key{
      .starts = open ? cuts.starts.starts().version : Version{},
      .hits = open ? cuts.opened.hits().version : Version{},
      .camera = open ? std::optional(cutting.view.camera) : std::nullopt,
      .occluders = gpu().versions().occluders,
      .light = shading.shadow > 0.0 ? lightDirection(frame.own.rays.axes(), shading) : glm::dvec3(0.0),
      .strength = {shading.occlusion, shading.shadow},
      .clip = frame.own.rays.clip(),
      .directions = {},
  };
  // A picture that is soon replaced is content with fewer directions, but takes the images that are there.
  if (frame.view().quality == Quality::Draft && !frame.view().maxError && isStale(key))
    key.directions = occlusion::draftDirections;
  update(cutting, steps, key, {}, [&](Regions) {
    std::optional<OcclusionPass::CutRays> opening;
    if (open)
      opening.emplace(OcclusionPass::CutRays{
          .rays = cutting.rays, .hitPoints = cuts.opened.hits().image, .rayStart = cuts.starts.starts().image});
    pass_.run(steps, gpu(), shading, key.light, key.clip, opening, key.directions, nodes_);
  });
}

}  // namespace fenestra
