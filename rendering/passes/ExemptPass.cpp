#include "rendering/passes/ExemptPass.h"

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

void ExemptPass::run(Steps& steps, const GpuScene& gpu, const Look& look, const RayFrame& rays,
                     const gl::Texture& picture, const FocusLayerPass::Sampling& sampling, Regions regions,
                     gl::Texture& exempted, const gl::Texture* occlusion) {
  FocusLayerPass::Sampling bounded = sampling;
  bounded.maxError = 0.25 * sampling.maxError.value_or(FocusLayerPass::usualBound);
  steps.add(regions, [this, &gpu, &look, &rays, &picture, bounded, &exempted, occlusion](Regions tile) {
    const FaintIndex& faint = gpu.exemptLabels().faint;
    const IntegralKind kind{.lit = look.shading.enabled,
                            .bounded = true,
                            .occlusion = occlusion,
                            .held = IntegralKind::Held::KeptLabels,
                            .faint = &faint};
    // How capped faces look does not matter to what clipping leaves out.
    gl::ShaderProgram& program = programs_.get(gl::Variant{{{"RAYS", 1}},
                                                           {scheduleChoice(gpu.schedule()),
                                                            rays.placesChoice(),
                                                            {"clip", "lib/clip/Faces.glsl"},
                                                            {"opening", "lib/opening/Exempt.glsl"}}} +
                                               integralVariant(gpu, kind));
    rays.setUniforms(program);
    bindIntegral(gpu, program, true);
    bindFaint(gpu, faint, program);
    bindFaintOpacities(gpu, faint, program);
    bindLabels(gpu.exemptLabels(), program);
    program.set(FocusLayerPass::integralUniforms(gpu, bounded, look.shading.enabled));
    program.bind("picture", picture);
    if (kind.lit) bindLight(gpu, program, rays.axes(), look.shading, kind);
    program.bind("exempted", exempted, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
