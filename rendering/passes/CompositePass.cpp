#include "rendering/passes/CompositePass.h"

#include "rendering/passes/SceneBinding.h"

namespace fenestra {

void CompositePass::run(const Inputs& inputs, const Scene& scene, std::span<const gl::Region> regions,
                        gl::Texture& picture) {
  const bool layer = inputs.contextLayer != nullptr;
  gl::ShaderProgram& program = programs_.get({{"CONTEXT_LAYER", layer}, {"EDITED", inputs.editMap != nullptr}});
  bindTexture(program, "focusLayer", 0, inputs.focusLayer);
  bindTexture(program, "hitPoints", 1, inputs.hitPoints);
  bindTexture(program, "distances", 2, inputs.distances);
  if (inputs.editMap) bindTexture(program, "editMap", 5, *inputs.editMap);
  program.set("widths", glm::vec2(inputs.widths));
  program.set("borderColour", glm::vec3(scene.cutaway.borderColour));
  if (layer) {
    bindTexture(program, "contextLayer", 3, *inputs.contextLayer);
    bindTexture(program, "silhouette", 4, *inputs.silhouette);
    const ContextLayer& look = scene.contextLayer;
    program.set("contextColour", glm::vec3(look.colour));
    program.set("contextWeights", glm::vec3(look.strength, look.curvatureWeight, look.silhouetteWeight));
    program.set("contextShade", glm::vec2(look.illuminationWeight, look.valueWeight));
    bindImage(program, "transferTables", 1, inputs.gpu->transferTables());
    program.set("transferMap", inputs.gpu->transferMap());
    // Curvature times the scale of the derivatives has no dimension.
    program.set("curvatureScale", static_cast<float>(inputs.gpu->derivative().spacing));
  }
  picture.bindImage(0, gl::Access::Write);
  program.dispatch(regions);
}

}  // namespace fenestra
