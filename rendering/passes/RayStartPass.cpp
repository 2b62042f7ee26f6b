#include "rendering/passes/RayStartPass.h"

#include "rendering/passes/SceneBinding.h"

namespace fenestra {

void RayStartPass::run(const RayFrame& rays, const gl::Texture& hitPoints, const gl::Texture& focusFilled,
                       const gl::Texture& distances, double openWidth, gl::Texture& rayStart) {
  gl::ShaderProgram& program = programs_.get();
  rays.setUniforms(program);
  bindTexture(program, "hitPoints", 0, hitPoints);
  bindTexture(program, "focusFilled", 1, focusFilled);
  bindTexture(program, "distances", 2, distances);
  program.set("openWidth", static_cast<float>(openWidth));
  rayStart.bindImage(0, gl::Access::Write);
  program.dispatch(rays.size());
}

}  // namespace fenestra
