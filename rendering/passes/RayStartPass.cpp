#include "rendering/passes/RayStartPass.h"

namespace fenestra {

void RayStartPass::Inputs::bind(gl::ShaderProgram& program) const {
  program.bind("hitPoints", hitPoints);
  if (given) {
    program.bind("givenStart", *given);
    return;
  }
  program.bind("focusFilled", focusFilled);
  program.bind("distances", distances);
  program.set("openWidth", static_cast<float>(openWidth));
  program.set("reach", static_cast<float>(reach));
}

void RayStartPass::run(Steps& steps, Schedule schedule, const RayFrame& rays, const Inputs& inputs,
                       const gl::Texture* editMap, Regions regions, gl::Texture& rayStart,
                       gl::Texture* borderDistance) {
  steps.add(regions, [this, schedule, &rays, inputs, editMap, &rayStart, borderDistance](Regions tile) {
    gl::ShaderProgram& program =
        programs_.get({{{"EDITED", editMap != nullptr}, inputs.define(), rays.clipDefine(), rays.scatterDefine()},
                       {scheduleChoice(schedule)}});
    rays.setUniforms(program);
    inputs.bind(program);
    if (editMap) program.bind("editMap", *editMap);
    program.bind("rayStart", rayStart, gl::Access::Write);
    if (borderDistance) program.bind("borderDistance", *borderDistance, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
