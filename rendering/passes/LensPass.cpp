#include "rendering/passes/LensPass.h"

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

void LensPass::run(Steps& steps, const GpuScene& gpu, const RayFrame& rays, const gl::Texture& hitPoints,
                   glm::dvec3 focusMiddle, Regions regions, gl::Texture& surface) {
  const auto anchorOf = [](const RayFrame& frame) {
    return frame.camera().eye + frame.axes().forward * frame.distance();
  };
  const glm::dvec3 anchor = anchorOf(rays);  // as shaders have world positions
  glm::vec3 sightBase(0.0f), sightDirection(0.0f);
  if (!sightHit_) sightHit_ = gl::Texture::make2D(gl::Format::RG32F, glm::ivec2(1));
  if (const std::optional<Camera> aimed = rays.camera().aimedAt(focusMiddle)) {
    sight_.emplace(*aimed, glm::ivec2(1), gpu.grid(), rays.clip(), gpu.refinement());
    sightBase = glm::vec3(anchorOf(*sight_) - anchor);
    sightDirection = glm::vec3(sight_->axes().forward);
    hitPointPass_.run(steps, gpu, *sight_, sightHit_);
  } else {
    const std::vector<glm::vec2> none{glm::vec2(nothing)};
    sightHit_.upload(std::span(none));
  }
  const glm::vec3 otherwise(focusMiddle - anchor);
  steps.add(regions, [this, &gpu, &rays, &hitPoints, sightBase, sightDirection, otherwise, &surface](Regions tile) {
    gl::ShaderProgram& program = programs_.get(
        gl::Variant{{}, {scheduleChoice(gpu.schedule()), derivativeChoice(gpu)}} + gridVariant(gpu) + rays.variant());
    rays.setUniforms(program);
    bindDerivative(gpu, program);
    program.set("sightBase", sightBase);
    program.set("sightDirection", sightDirection);
    program.set("focusMiddle", otherwise);
    program.bind("sightHit", sightHit_);
    program.bind("hitPoints", hitPoints);
    program.bind("surface", surface, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
