#pragma once
// Stage 7: the paper's equation, and the picture on the screen.

#include <span>

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/passes/GpuScene.h"
#include "rendering/scene/Scene.h"

namespace fenestra {

class CompositePass {
 public:
  /// What the scene uses; null leaves a stage out.
  struct Inputs {
    const gl::Texture* focusLayer = nullptr;
    const gl::Texture* hitPoints = nullptr;  ///< with distances: a cutaway with its border
    const gl::Texture* distances = nullptr;
    const gl::Texture* contextLayer = nullptr;  ///< with silhouette
    const gl::Texture* silhouette = nullptr;
    const GpuScene* gpu = nullptr;         ///< with contextLayer, for the context's own colours
    const gl::Texture* editMap = nullptr;  ///< of brush strokes
    glm::dvec2 widths{0.0};                ///< w_open, w_border in rendered pixels
    double curvatureScale = 1.0;           ///< mm, the scale of the derivatives
  };
  /// Writes premultiplied RGBA32F without background.
  void run(const Inputs& inputs, const Scene& scene, std::span<const gl::Region> regions, gl::Texture& picture);

 private:
  gl::ShaderVariants programs_{"Composite.comp"};
};

}  // namespace fenestra
