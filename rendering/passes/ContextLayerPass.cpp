#include "rendering/passes/ContextLayerPass.h"

#include <algorithm>

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

gl::ShaderProgram& ContextLayerPass::prepared(const GpuScene& gpu, const Shading& shading, const RayFrame& rays) {
  gl::ShaderProgram& program =
      programs_.get({{volumeDefine(gpu),
                      refinementDefine(gpu),
                      rays.clipDefine(),
                      rays.scatterDefine(),
                      {"DERIVATIVE_BYTES", static_cast<int>(gl::bytesPerTexel(gpu.derivative().texture.format()))}},
                     {scheduleChoice(gpu.schedule())}});
  rays.setBlocks(program);
  bindVolume(gpu, program);
  const DerivativeVolume& derivative = gpu.derivative();
  program.bind("derivativeVolume", derivative.texture);
  const glm::dvec3 factor(derivative.factor);
  const glm::dmat3 derivativeFromWorld =
      glm::dmat3(glm::dvec3(1.0 / factor.x, 0.0, 0.0), glm::dvec3(0.0, 1.0 / factor.y, 0.0),
                 glm::dvec3(0.0, 0.0, 1.0 / factor.z)) *
      glm::dmat3(gpu.grid().indexFromWorld());
  program.set(DerivativeBlock{Std140Mat3(glm::mat3(glm::transpose(derivativeFromWorld))), glm::vec3(factor),
                              static_cast<float>(derivative.texelScale)});
  // A surface this near to the box's entry is where the scan ends; this near to the focus it is the focus's own.
  const glm::dvec3 spacing = gpu.grid().spacing;
  program.set("contextMargin", static_cast<float>(0.5 * std::min({spacing.x, spacing.y, spacing.z})));
  program.set(lightBlock(rays.axes(), shading));
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
