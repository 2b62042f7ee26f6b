#include "rendering/passes/HitPointPass.h"

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

void HitPointPass::run(const GpuScene& scene, const RayFrame& rays, gl::Texture& hitPoints, glm::ivec2 offset) {
  gl::ShaderProgram& program = programs_.get({volumeDefine(scene), focusDefine(scene)});
  rays.setUniforms(program);
  bindVolume(scene, program);
  bindFocus(scene, program);
  bindFirstHit(scene, program);
  program.set("pixelOffset", offset);
  hitPoints.bindImage(0, gl::Access::Write);
  program.dispatch(glm::ivec2(hitPoints.size()));
}

}  // namespace fenestra
