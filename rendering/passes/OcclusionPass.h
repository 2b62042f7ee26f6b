#pragma once
// Ambient occlusion and the soft shadow, before stage 5: what is left of ambient and of direct light at the centres of
// the cells of rendering/scene/Occlusion.h, which defines both.

#include <optional>

#include "rendering/gl/Buffer.h"
#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/passes/Steps.h"
#include "rendering/scene/Occlusion.h"

namespace fenestra {

class OcclusionPass {
 public:
  explicit OcclusionPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : occluders_("Occluders.comp", programs), nodes_("Occlusion.comp", programs) {}
  /// Of the camera that cuts the opening: its first hits, and where its rays start.
  struct Opening {
    const RayFrame& rays;
    const gl::Texture& hitPoints;
    const gl::Texture& rayStart;
  };
  /// Writes a word a cell of GpuScene::occluders(), x fastest: what is left of ambient light in its lower 16 bits and
  /// of direct light in its upper ones, 65535 for all of it. `light`: towards the light, unit, world. `gpu` has
  /// occluders.
  void run(Steps& steps, const GpuScene& gpu, const Shading& shading, glm::dvec3 light, const Clip& clip,
           const std::optional<Opening>& opening, const occlusion::Directions& directions, gl::Buffer& nodes);
  void release() {
    medium_ = {};
    directions_ = {};
  }
  std::size_t bytes() const { return medium_.bytes() + directions_.bytes(); }

 private:
  gl::ShaderVariants occluders_, nodes_;
  gl::Buffer medium_;      ///< extinction of each cell as the volume is cut open, 1/mm
  gl::Buffer directions_;  ///< cells per mm
};

}  // namespace fenestra
