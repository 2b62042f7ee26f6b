#include "rendering/passes/ProtectedLayerPass.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

gl::ShaderProgram& ProtectedLayerPass::program(const GpuScene& gpu, bool lit, const RayFrame& rays,
                                               const gl::Texture* occlusion, Shown shown) {
  const bool labelsAlone = shown == Shown::ProtectedLabels, withFocus = shown == Shown::AllWithFocus;
  gl::Variant variant{{volumeDefine(gpu),
                       refinementDefine(gpu),
                       tableDefine(),
                       segmentsDefine(),
                       faintDefine(gpu),
                       occlusionDefine(occlusion),
                       {"IMPORTANCE_LEVELS", withFocus},
                       {"APART", false},
                       {"LABELS_ALONE", labelsAlone},
                       rays.clipDefine(),
                       rays.scatterDefine(),
                       {"RAYS", 1}},
                      {scheduleChoice(gpu.schedule()),
                       withFocus ? focusChoice(gpu)
                                 : gl::Choice{"focus", labelsAlone ? "lib/focus/Labels.glsl" : "lib/focus/None.glsl"},
                       lightChoice(lit),
                       {"opening", "lib/opening/Removed.glsl"},
                       integralChoice(gpu, true)}};
  const std::vector<gl::Define> plain{{"FOCUS_PALETTE", false}, {"FOCUS_FUNCTIONS", false}, {"FOCUS_SMOOTH", false}};
  std::ranges::copy(withFocus ? focusDefines(gpu, lit) : plain, std::back_inserter(variant.defines));
  return programs_.get(variant);
}

void ProtectedLayerPass::run(Steps& steps, const GpuScene& gpu, const Look& look, const RayFrame& rays,
                             const FocusLayerPass::Opening& opening, const FocusLayerPass::Sampling& sampling,
                             Regions regions, gl::Texture& protectedLayer, const gl::Texture* occlusion, Shown shown) {
  FocusLayerPass::Sampling bounded = sampling;
  bounded.maxError = 0.5 * sampling.maxError.value_or(std::max(FocusLayerPass::usualBound, 4.0 * sampling.tolerance));
  steps.add(regions, [this, &gpu, &look, &rays, opening, bounded, &protectedLayer, occlusion, shown](Regions tile) {
    const bool lit = look.shading.enabled;
    gl::ShaderProgram& program = this->program(gpu, lit, rays, occlusion, shown);
    rays.setUniforms(program);
    bindVolume(gpu, program);
    bindTransferSegments(gpu, program);
    bindFaint(gpu, program);
    if (shown == Shown::ProtectedLabels)
      bindLabels(gpu.protectedLabels(), program);
    else if (shown == Shown::AllWithFocus)
      bindFocusLook(gpu, program, look, true);
    else
      program.bind("occupiedSkip", gpu.contextSkip());
    program.set(FocusLayerPass::integralUniforms(gpu, bounded, look.shading.enabled));
    program.bind("rayStart", opening.rayStart);
    program.bind("hitPoints", opening.hitPoints);
    if (lit) bindLight(gpu, program, rays.axes(), look.shading, occlusion);
    program.bind("protectedLayer", protectedLayer, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
