#include "rendering/passes/CompositePass.h"

#include "rendering/gpu/SceneBinding.h"
#include "rendering/passes/ContextLinesPass.h"

namespace fenestra {
namespace {

gl::Choice faintChoice(const MethodStages& method, bool isFaint) {
  if (!isFaint) return {"faint", "lib/faint/None.glsl"};
  if (method.lens) return {"faint", "lib/faint/Lens.glsl"};
  switch (method.sparseness) {
    case Sparseness::Opacity:
      break;
    case Sparseness::Colour:
      return {"faint", "lib/faint/Colour.glsl"};
    case Sparseness::ScreenDoor:
      return {"faint", "lib/faint/ScreenDoor.glsl"};
  }
  return {"faint", "lib/faint/Opacity.glsl"};
}

gl::Variant variantOf(const GpuScene& gpu, const CompositePass::Inputs& inputs, const MethodStages& method) {
  gl::Variant variant{
      {{"SCATTERED", inputs.scattered}},
      {scheduleChoice(gpu.schedule()),
       faintChoice(method, inputs.faintLayer),
       {"edits", inputs.editMap ? "lib/edits/Map.glsl" : "lib/edits/None.glsl"},
       {"front", inputs.protectedLayer ? "lib/front/ProtectedLabels.glsl" : "lib/front/None.glsl"},
       {"contextLayer", inputs.contextLayer ? "lib/contextLayer/Edges.glsl" : "lib/contextLayer/None.glsl"}}};
  if (inputs.contextLayer) variant += {{{"APART", inputs.rayStart != nullptr}, tableDefine()}, {}};
  return variant;
}

void setLens(gl::ShaderProgram& program, const gl::Texture& surface, const MethodStages::Lens& lens, const Grid& grid) {
  program.bind("lensSurface", surface);
  program.set("lens", glm::vec3(1.0 / radiusOf(lens, grid), lens.bends, lens.rim));
  program.set("lensFade", static_cast<int>(lens.fade));
}

}  // namespace

void CompositePass::run(Steps& steps, const GpuScene& gpu, const Inputs& inputs, const Look& look, Regions regions,
                        gl::Texture& picture) {
  const MethodStages method = stagesOf(look.method);
  steps.add(regions, [this, &gpu, inputs, method, &look, &picture](Regions tile) {
    const bool hasLayer = inputs.contextLayer != nullptr;
    gl::ShaderProgram& program = programs_.get(variantOf(gpu, inputs, method));
    program.bind("focusLayer", inputs.focusLayer);
    program.bind("hitPoints", inputs.hitPoints);
    program.bind("distances", inputs.distances);
    if (inputs.editMap) program.bind("editMap", *inputs.editMap);
    if (inputs.protectedLayer) program.bind("protectedLayer", *inputs.protectedLayer);
    if (inputs.faintLayer) {
      program.bind("faintLayer", *inputs.faintLayer);
      if (method.lens)
        setLens(program, *inputs.lensSurface, *method.lens, gpu.grid());
      else
        program.set("faintOpacity", static_cast<float>(method.faintOpacity));
    }
    if (inputs.rayStart && hasLayer) program.bind("rayStart", *inputs.rayStart);
    program.set(CutawayUniforms{glm::vec2(inputs.widths), glm::vec3(look.cutaway.borderColour)});
    if (hasLayer) {
      program.bind("contextLayer", *inputs.contextLayer);
      program.bind("silhouette", *inputs.silhouette);
      program.set(uniformsOf(look.contextLayer, gpu.derivative(), inputs.leastLine));
      bindTransfer(gpu, program);
    }
    program.bind("picture", picture, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
