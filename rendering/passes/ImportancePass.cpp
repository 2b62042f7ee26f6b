#include "rendering/passes/ImportancePass.h"

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

void ImportancePass::run(Steps& steps, const GpuScene& gpu, const KeptLabels& level, const RayFrame& rays,
                         const gl::Texture& hitPoints, gl::Texture& hits, bool isHigher) {
  steps.add(rays.size(), [this, &gpu, &level, &rays, &hitPoints, &hits, isHigher](Regions tile) {
    const gl::Choice lower{"lower", isHigher ? "lib/lower/Level.glsl" : "lib/lower/None.glsl"};
    gl::ShaderProgram& program = programs_.get(
        gl::Variant{{}, {scheduleChoice(gpu.schedule()), focusChoice(level), translucentChoice(gpu.faint()), lower}} +
        searchVariant(gpu) + rays.variant());
    rays.setUniforms(program);
    bindLabelHits(gpu, level, program);
    bindFaint(gpu, gpu.faint(), program);
    program.bind("hitPoints", hitPoints);
    program.bind("importantHits", hits, isHigher ? gl::Access::ReadWrite : gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
