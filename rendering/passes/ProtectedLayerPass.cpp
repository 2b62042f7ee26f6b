#include "rendering/passes/ProtectedLayerPass.h"

#include <algorithm>

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

void ProtectedLayerPass::run(Steps& steps, const GpuScene& gpu, const Look& look, const RayFrame& rays,
                             const FocusLayerPass::Opening& opening, const FocusLayerPass::Sampling& sampling,
                             Regions regions, gl::Texture& protectedLayer, const gl::Buffer* occlusion, Shown shown) {
  const bool labelsAlone = shown == Shown::ProtectedLabels;
  FocusLayerPass::Sampling bounded = sampling;
  bounded.maxError = 0.5 * sampling.maxError.value_or(std::max(FocusLayerPass::usualBound, 4.0 * sampling.tolerance));
  steps.add(regions,
            [this, &gpu, &look, &rays, opening, bounded, &protectedLayer, occlusion, labelsAlone](Regions tile) {
              const bool lit = look.shading.enabled;
              gl::ShaderProgram& program =
                  programs_.get({{volumeDefine(gpu),
                                  refinementDefine(gpu),
                                  tableDefine(),
                                  segmentsDefine(),
                                  faintDefine(gpu),
                                  {"FOCUS_PALETTE", false},
                                  {"FOCUS_FUNCTIONS", false},
                                  {"FOCUS_SMOOTH", false},
                                  occlusionDefine(occlusion),
                                  {"APART", false},
                                  {"LABELS_ALONE", labelsAlone},
                                  rays.clipDefine(),
                                  rays.scatterDefine(),
                                  {"RAYS", 1}},
                                 {scheduleChoice(gpu.schedule()),
                                  {"focus", labelsAlone ? "lib/focus/Labels.glsl" : "lib/focus/None.glsl"},
                                  lightChoice(lit),
                                  {"opening", "lib/opening/Removed.glsl"},
                                  integralChoice(gpu, true)}});
              rays.setBlocks(program);
              bindVolume(gpu, program);
              bindTransferSegments(gpu, program);
              bindFaint(gpu, program);
              if (labelsAlone)
                bindLabels(gpu.protectedLabels(), program);
              else
                program.bind("occupiedSkip", gpu.contextSkip());
              program.set(FocusLayerPass::integralBlock(bounded));
              program.bind("rayStart", opening.rayStart);
              program.bind("hitPoints", opening.hitPoints);
              if (lit) bindLight(gpu, program, rays.axes(), look.shading);
              bindOcclusion(gpu, program, occlusion);
              program.bind("protectedLayer", protectedLayer, gl::Access::Write);
              program.dispatch(tile);
            });
}

}  // namespace fenestra
