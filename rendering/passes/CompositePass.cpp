#include "rendering/passes/CompositePass.h"

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

void CompositePass::run(const Inputs& inputs, const Scene& scene, std::span<const gl::Region> regions,
                        gl::Texture& picture) {
  const bool layer = inputs.contextLayer != nullptr;
  gl::ShaderProgram& program = programs_.get({{"CONTEXT_LAYER", layer}, {"EDITED", inputs.editMap != nullptr}});
  bindImage(program, "focusLayer", 1, inputs.focusLayer);
  bindImage(program, "hitPoints", 2, inputs.hitPoints);
  bindImage(program, "distances", 3, inputs.distances);
  if (inputs.editMap) bindImage(program, "editMap", 4, *inputs.editMap);
  program.set("widths", glm::vec2(inputs.widths));
  program.set("borderColour", glm::vec3(scene.look.cutaway.borderColour));
  if (layer) {
    bindImage(program, "contextLayer", 5, *inputs.contextLayer);
    bindImage(program, "silhouette", 6, *inputs.silhouette);
    const ContextLayer& look = scene.look.contextLayer;
    program.set("contextColour", glm::vec3(look.colour));
    program.set("contextWeights", glm::vec3(look.strength, look.curvatureWeight, look.silhouetteWeight));
    program.set("contextShade", glm::vec2(look.illuminationWeight, look.valueWeight));
    bindImage(program, "transferTables", 7, inputs.gpu->transferTables());
    program.set("transferMap", inputs.gpu->transferMap());
    // Curvature times the scale of the derivatives has no dimension.
    program.set("curvatureScale", static_cast<float>(inputs.gpu->derivative().spacing));
  }
  picture.bindImage(0, gl::Access::Write);
  program.dispatch(regions);
}

}  // namespace fenestra
