#include "rendering/passes/ExemptPass.h"

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

void ExemptPass::run(Steps& steps, const GpuScene& gpu, const Look& look, const RayFrame& rays,
                     const gl::Texture& picture, const FocusLayerPass::Sampling& sampling, Regions regions,
                     gl::Texture& exempted, const gl::Texture* occlusion) {
  FocusLayerPass::Sampling bounded = sampling;
  bounded.maxError = 0.25 * sampling.maxError.value_or(FocusLayerPass::usualBound);
  steps.add(regions, [this, &gpu, &look, &rays, &picture, bounded, &exempted, occlusion](Regions tile) {
    const bool lit = look.shading.enabled;
    gl::ShaderProgram& program = programs_.get({{volumeDefine(gpu),
                                                 refinementDefine(gpu),
                                                 tableDefine(),
                                                 segmentsDefine(),
                                                 faintDefine(gpu),
                                                 {"FOCUS_PALETTE", false},
                                                 {"FOCUS_FUNCTIONS", false},
                                                 {"FOCUS_SMOOTH", false},
                                                 occlusionDefine(occlusion),
                                                 {"APART", false},
                                                 {"CLIPPED", 1},
                                                 rays.scatterDefine(),
                                                 {"RAYS", 1}},
                                                {scheduleChoice(gpu.schedule()),
                                                 {"focus", "lib/focus/Labels.glsl"},
                                                 lightChoice(lit),
                                                 {"opening", "lib/opening/Exempt.glsl"},
                                                 integralChoice(gpu, true)}});
    rays.setUniforms(program);
    bindVolume(gpu, program);
    bindTransferSegments(gpu, program);
    bindFaint(gpu, program);
    bindLabels(gpu.exemptLabels(), program);
    program.set(FocusLayerPass::integralUniforms(gpu, bounded, look.shading.enabled));
    program.bind("picture", picture);
    if (lit) bindLight(gpu, program, rays.axes(), look.shading, occlusion);
    program.bind("exempted", exempted, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
