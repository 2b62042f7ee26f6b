#include "rendering/passes/HitPointPass.h"

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

void HitPointPass::run(const GpuScene& scene, const RayFrame& rays, gl::Texture& hitPoints, glm::ivec2 offset) {
  gl::ShaderProgram& program =
      programs_.get({{volumeDefine(scene)}, {scheduleChoice(scene.schedule()), focusChoice(scene)}});
  rays.setBlocks(program);
  bindFirstHit(scene, program);
  program.set("pixelOffset", offset);
  program.bind("hitPoints", hitPoints, gl::Access::Write);
  program.dispatch(glm::ivec2(hitPoints.size()));
}

}  // namespace fenestra
