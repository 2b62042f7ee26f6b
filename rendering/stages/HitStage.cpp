#include "rendering/stages/HitStage.h"

#include "rendering/stages/Images.h"

namespace fenestra {
namespace {

/// The integral of a draft reads a spline's samples, too.
HitSurface surfaceFor(const Frame& frame, const GpuScene& gpu) {
  const bool draft = frame.view().quality == Quality::Draft && !frame.sampling.maxError;
  return draft && gpu.refinement() > 1 ? HitSurface::Samples : HitSurface::Exact;
}

}  // namespace

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
                   .clip = sight.rays.clip(),
                   .surface = surfaceFor(frame, gpu())};
  update(sight, steps, key, {}, [&](Regions) {
    gl::Texture& hits = sized(hits_, gl::Format::RG32F, sight.view.size);
    pass_.run(steps, gpu(), sight.rays, hits, glm::ivec2(0), key.surface);
  });
}

}  // namespace fenestra
