#include "rendering/passes/MaximumPass.h"

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

void MaximumPass::run(Steps& steps, const GpuScene& gpu, const MethodStages::Maximum& maximum, const RayFrame& rays,
                      const std::optional<FocusLayerPass::RayStarts>& opening, const gl::Texture& focusLayer,
                      double leastTransmittance, Regions regions, gl::Texture& picture) {
  steps.add(regions, [this, &gpu, maximum, &rays, opening, &focusLayer, leastTransmittance, &picture](Regions tile) {
    gl::Variant variant = gl::Variant{{{"SEGMENTS_PER_ROW", GpuScene::segmentsPerRow}, tableDefine()},
                                      {scheduleChoice(gpu.schedule()),
                                       translucentChoice(gpu.faint()),
                                       focusChoice(gpu),
                                       {"begins", opening ? "lib/begins/Opening.glsl" : "lib/begins/Entry.glsl"}}} +
                          sampledVariant(gpu) + rays.variant();
    if (opening) variant += gl::Variant{{}, {{"hole", opening->hole ? "lib/hole/Apart.glsl" : "lib/hole/None.glsl"}}};
    gl::ShaderProgram& program = programs_.get(variant);
    rays.setUniforms(program);
    bindContextValues(gpu, program);
    bindFocus(gpu, program);
    bindFaint(gpu, gpu.faint(), program);
    bindFaintOpacities(gpu, gpu.faint(), program);
    if (opening) {
      program.bind("rayStart", opening->rayStart);
      program.bind("hitPoints", opening->hitPoints);
      if (opening->hole) program.bind("hole", *opening->hole);
    }
    program.set("leastStretch", static_cast<float>(hair(gpu.grid())));
    program.set("thickness", static_cast<float>(maximum.thickness));
    program.set("leastTransmittance", static_cast<float>(leastTransmittance));
    program.bind("focusLayer", focusLayer);
    program.bind("picture", picture, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
