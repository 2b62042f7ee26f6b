#include "rendering/passes/RayStartPass.h"

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

void RayStartPass::Inputs::bind(gl::ShaderProgram& program, unsigned unit) const {
  bindImage(program, "hitPoints", unit, hitPoints);
  bindImage(program, "focusFilled", unit + 1, focusFilled);
  bindImage(program, "distances", unit + 2, distances);
  program.set("openWidth", static_cast<float>(openWidth));
}

void RayStartPass::run(const RayFrame& rays, const Inputs& inputs, const gl::Texture* editMap,
                       std::span<const gl::Region> regions, gl::Texture& rayStart) {
  gl::ShaderProgram& program = programs_.get({{"EDITED", editMap != nullptr}});
  rays.setUniforms(program);
  inputs.bind(program, 1);
  if (editMap) bindImage(program, "editMap", 4, *editMap);
  rayStart.bindImage(0, gl::Access::Write);
  program.dispatch(regions);
}

}  // namespace fenestra
