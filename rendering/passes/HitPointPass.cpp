#include "rendering/passes/HitPointPass.h"

#include "rendering/passes/SceneBinding.h"

namespace fenestra {

void HitPointPass::run(const GpuScene& scene, const RayFrame& rays, gl::Texture& hitPoints, glm::ivec2 offset) {
  gl::ShaderProgram& program = programs_.get({focusDefine(scene)});
  rays.setUniforms(program);
  bindVolume(scene, program);
  bindFocus(scene, program);
  bindTexture(program, "contextSkip", firstFreeUnit, scene.contextSkip());
  scene.gaps().bind(1);
  program.set("gapCount", scene.gapCount());
  program.set("pixelOffset", offset);
  hitPoints.bindImage(0, gl::Access::Write);
  program.dispatch(glm::ivec2(hitPoints.size()));
}

}  // namespace fenestra
