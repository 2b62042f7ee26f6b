#include "rendering/passes/RayStartPass.h"

#include "rendering/passes/SceneBinding.h"

namespace fenestra {

void RayStartPass::Inputs::bind(gl::ShaderProgram& program, unsigned unit) const {
  bindTexture(program, "hitPoints", unit, hitPoints);
  bindTexture(program, "focusFilled", unit + 1, focusFilled);
  bindTexture(program, "distances", unit + 2, distances);
  program.set("openWidth", static_cast<float>(openWidth));
}

void RayStartPass::run(const RayFrame& rays, const Inputs& inputs, const gl::Texture* editMap,
                       std::span<const gl::Region> regions, gl::Texture& rayStart) {
  gl::ShaderProgram& program = programs_.get({{"EDITED", editMap != nullptr}});
  rays.setUniforms(program);
  inputs.bind(program, 0);
  if (editMap) bindTexture(program, "editMap", 3, *editMap);
  rayStart.bindImage(0, gl::Access::Write);
  program.dispatch(regions);
}

}  // namespace fenestra
