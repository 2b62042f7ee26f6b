#pragma once
// Stage 6: curvature, illumination and value of the context's first surface over the focus.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

class ContextLayerPass {
 public:
  explicit ContextLayerPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : programs_("ContextLayer.comp", programs) {}
  /// Writes `contextLayer` (RGBA32F: κ1, κ2 in 1/mm, illumination, coded value; `nothing` in κ1 where there is no such
  /// surface) and `silhouette` (R32F: 1 - |n·v|). `regions` hold the focus projection; beyond it nothing is meant.
  void run(Steps& steps, const GpuScene& gpu, const Shading& shading, const RayFrame& rays,
           const gl::Texture& hitPoints, Regions regions, gl::Texture& contextLayer, gl::Texture& silhouette);

 private:
  /// The scene's variant with all that it reads but the hit points.
  gl::ShaderProgram& prepared(const GpuScene& gpu, const Shading& shading, const RayFrame& rays);

  gl::ShaderVariants programs_;
};

}  // namespace fenestra
