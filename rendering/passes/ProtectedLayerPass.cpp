#include "rendering/passes/ProtectedLayerPass.h"

#include <algorithm>

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

namespace {
IntegralKind::Held heldFor(ProtectedLayerPass::Shown shown) {
  switch (shown) {
    case ProtectedLayerPass::Shown::ProtectedLabels:
      return IntegralKind::Held::KeptLabels;
    case ProtectedLayerPass::Shown::AllWithFocus:
      return IntegralKind::Held::OfScene;
    case ProtectedLayerPass::Shown::All:
      break;
  }
  return IntegralKind::Held::None;
}
}  // namespace

void ProtectedLayerPass::run(Steps& steps, const GpuScene& gpu, const Look& look, const RayFrame& rays,
                             const FocusLayerPass::RayStarts& opening, const FocusLayerPass::Sampling& sampling,
                             Regions regions, gl::Texture& protectedLayer, const gl::Texture* occlusion, Shown shown) {
  FocusLayerPass::Sampling bounded = sampling;
  bounded.maxError = 0.5 * sampling.maxError.value_or(std::max(FocusLayerPass::usualBound, 4.0 * sampling.tolerance));
  steps.add(regions, [this, &gpu, &look, &rays, opening, bounded, &protectedLayer, occlusion, shown](Regions tile) {
    const FaintIndex& faint = shown == Shown::ProtectedLabels ? gpu.protectedLabels().faint : gpu.faint();
    const IntegralKind kind{.lit = look.shading.enabled,
                            .bounded = true,
                            .occlusion = occlusion,
                            .held = heldFor(shown),
                            .faint = &faint,
                            .hasLevels = shown == Shown::AllWithFocus};
    gl::ShaderProgram& program =
        programs_.get(gl::Variant{{{"RAYS", 1}, {"LABELS_ALONE", shown == Shown::ProtectedLabels}},
                                  {scheduleChoice(gpu.schedule()), {"opening", "lib/opening/Removed.glsl"}}} +
                      integralVariant(gpu, kind) + rays.variant());
    rays.setUniforms(program);
    bindIntegral(gpu, program, true);
    bindFaint(gpu, faint, program);
    bindFaintOpacities(gpu, faint, program);
    if (shown == Shown::ProtectedLabels)
      bindLabels(gpu.protectedLabels(), program);
    else if (shown == Shown::AllWithFocus)
      bindFocusLook(gpu, program, look, true);
    else
      program.bind("occupiedSkip", gpu.contextSkip());
    program.set(FocusLayerPass::integralUniforms(gpu, bounded, look.shading.enabled));
    program.bind("rayStart", opening.rayStart);
    program.bind("hitPoints", opening.hitPoints);
    if (kind.lit) bindLight(gpu, program, rays.axes(), look.shading, kind);
    program.bind("protectedLayer", protectedLayer, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
