#include "rendering/passes/HitPointPass.h"

#include "rendering/gpu/SceneBinding.h"
#include "rendering/gpu/SceneVariant.h"

namespace fenestra {

void HitPointPass::run(Steps& steps, const GpuScene& scene, const RayFrame& rays, gl::Texture& hitPoints,
                       glm::ivec2 offset, HitSurface surface) {
  add(steps, scene, rays, {glm::ivec2(0), glm::ivec2(hitPoints.size())}, hitPoints, offset, surface);
}

void HitPointPass::run(Steps& steps, const GpuScene& scene, const RayFrame& rays, const gl::Region& region,
                       gl::Texture& hitPoints) {
  add(steps, scene, rays, region, hitPoints, glm::ivec2(0), HitSurface::Exact);
}

void HitPointPass::add(Steps& steps, const GpuScene& scene, const RayFrame& rays, const gl::Region& region,
                       gl::Texture& hitPoints, glm::ivec2 offset, HitSurface surface) {
  steps.add(Regions(&region, 1), [this, &scene, &rays, &hitPoints, offset, surface](Regions tile) {
    gl::ShaderProgram& program = programs_.get(
        gl::Variant{{}, {scheduleChoice(scene.schedule()), focusChoice(scene), translucentChoice(scene.faint())}} +
        searchVariant(scene, surface) + rays.variant());
    rays.setUniforms(program);
    bindFirstHit(scene, program, surface);
    bindFaint(scene, scene.faint(), program);
    program.set("pixelOffset", offset);
    program.bind("hitPoints", hitPoints, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
