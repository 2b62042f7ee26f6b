#include "rendering/passes/RayStartPass.h"

namespace fenestra {

gl::Choice RayStartPass::Inputs::choice(const RayFrame& rays) const {
  return {"starts", given                ? "lib/starts/Given.glsl"
                    : rays.isScattered() ? "lib/starts/BlendScattered.glsl"
                                         : "lib/starts/Blend.glsl"};
}

void RayStartPass::Inputs::bind(gl::ShaderProgram& program, const RayFrame& rays) const {
  program.bind("hitPoints", hitPoints);
  if (given) {
    program.bind("givenStart", *given);
    return;
  }
  program.bind("focusFilled", focusFilled);
  program.bind("distances", distances);
  program.set("openWidth", static_cast<float>(openWidth));
  if (rays.isScattered()) program.set("reach", static_cast<float>(reach));
}

void RayStartPass::run(Steps& steps, Schedule schedule, const RayFrame& rays, const Inputs& inputs,
                       const gl::Texture* editMap, Regions regions, gl::Texture& rayStart,
                       gl::Texture* borderDistance) {
  steps.add(regions, [this, schedule, &rays, inputs, editMap, &rayStart, borderDistance](Regions tile) {
    const gl::Choice edits{"edits", editMap ? "lib/edits/Map.glsl" : "lib/edits/None.glsl"};
    gl::ShaderProgram& program =
        programs_.get(gl::Variant{{}, {scheduleChoice(schedule), inputs.choice(rays), edits}} + rays.variant());
    rays.setUniforms(program);
    inputs.bind(program, rays);
    if (editMap) program.bind("editMap", *editMap);
    program.bind("rayStart", rayStart, gl::Access::Write);
    if (borderDistance) program.bind("borderDistance", *borderDistance, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
