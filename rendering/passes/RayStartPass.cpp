#include "rendering/passes/RayStartPass.h"

namespace fenestra {

void RayStartPass::Inputs::bind(gl::ShaderProgram& program) const {
  program.bind("hitPoints", hitPoints);
  program.bind("focusFilled", focusFilled);
  program.bind("distances", distances);
  program.set("openWidth", static_cast<float>(openWidth));
}

void RayStartPass::run(Schedule schedule, const RayFrame& rays, const Inputs& inputs, const gl::Texture* editMap,
                       std::span<const gl::Region> regions, gl::Texture& rayStart) {
  gl::ShaderProgram& program = programs_.get({{{"EDITED", editMap != nullptr}}, {scheduleChoice(schedule)}});
  rays.setBlocks(program);
  inputs.bind(program);
  if (editMap) program.bind("editMap", *editMap);
  program.bind("rayStart", rayStart, gl::Access::Write);
  program.dispatch(regions);
}

}  // namespace fenestra
