#include "rendering/passes/ContextLayerPass.h"

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

gl::ShaderProgram& ContextLayerPass::prepared(const GpuScene& gpu, const Shading& shading, const RayFrame& rays) {
  gl::ShaderProgram& program = programs_.get(gl::Variant{{}, {scheduleChoice(gpu.schedule()), derivativeChoice(gpu)}} +
                                             volumeVariant(gpu) + rays.variant());
  rays.setUniforms(program);
  bindVolume(gpu, program);
  bindDerivative(gpu, program);
  program.set(lightUniforms(rays.axes(), shading));
  return program;
}

void ContextLayerPass::run(Steps& steps, const GpuScene& gpu, const Shading& shading, const RayFrame& rays,
                           const gl::Texture& hitPoints, Regions regions, gl::Texture& contextLayer,
                           gl::Texture& silhouette) {
  steps.add(regions, [this, &gpu, &shading, &rays, &hitPoints, &contextLayer, &silhouette](Regions tile) {
    gl::ShaderProgram& program = prepared(gpu, shading, rays);
    program.bind("hitPoints", hitPoints);
    program.bind("contextLayer", contextLayer, gl::Access::Write);
    program.bind("silhouette", silhouette, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
