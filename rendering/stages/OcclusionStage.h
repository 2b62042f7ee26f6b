#pragma once
// Ambient occlusion and the soft shadow (rendering/scene/Occlusion.h), through the volume as it is cut open.

#include "rendering/passes/OcclusionPass.h"
#include "rendering/stages/StartStages.h"

namespace fenestra {

struct OcclusionKey {
  Version starts, hits;          ///< those of the camera that cuts the opening; none without one
  std::optional<Camera> camera;  ///< that one
  std::uint64_t occluders;
  glm::dvec3 light;     ///< 0 without shadows
  glm::dvec2 strength;  ///< x: occlusion; y: shadow
  Clip clip;
  occlusion::Directions directions;
  bool operator==(const OcclusionKey&) const = default;
};

class OcclusionStage : public KeyedStage<OcclusionKey> {
 public:
  OcclusionStage(StageList& list, const StartStages& own, const StartStages& other);
  bool isUsed(const Frame& frame) const override { return hasOcclusion(frame.look()) && frame.view().occlusion; }
  void begin(const Frame& frame, Steps& steps) override;

  /// RGBA32UI, of OcclusionPass; none in pictures without either.
  Output nodes() const { return {nodes_, version()}; }

 private:
  const StartStages& own_;
  const StartStages& other_;
  OcclusionPass pass_{gpu().programs()};
  gl::Texture nodes_;
};

}  // namespace fenestra
