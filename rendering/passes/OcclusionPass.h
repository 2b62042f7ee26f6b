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
      : occluders_("Occluders.comp", programs),
        occlusion_("Occlusion.comp", programs),
        nodes_("OcclusionNodes.comp", programs) {}
  /// The camera that cuts the opening: its first hits, and where its rays start.
  struct CutRays {
    const RayFrame& rays;
    const gl::Texture& hitPoints;
    const gl::Texture& rayStart;
  };
  /// Writes a texel a cell of GpuScene::occluders(), the cells' z below y: what is left of light at the centres of the
  /// cell, of that behind it along x, along y, and along both, or of the last one. The lower 16 bits are of ambient
  /// light and the upper ones of direct light, 65535 for all of it. `light`: towards the light, unit, world. `gpu` has
  /// occluders.
  void run(Steps& steps, const GpuScene& gpu, const Shading& shading, glm::dvec3 light, const Clip& clip,
           const std::optional<CutRays>& opening, const occlusion::Directions& directions, gl::Texture& nodes);
  void release() {
    medium_ = {};
    nodeValues_ = {};
    steps_ = {};
  }
  std::size_t bytes() const { return medium_.bytes() + nodeValues_.bytes() + steps_.bytes(); }

 private:
  gl::ShaderVariants occluders_, occlusion_, nodes_;
  gl::Texture medium_;      ///< extinction of each cell as the volume is cut open, 1/mm; z below y
  gl::Texture nodeValues_;  ///< what is left of light at each cell's centre: 16 bits of ambient, 16 of direct light
  gl::Texture steps_;       ///< of rays in each direction
};

}  // namespace fenestra
