#pragma once
// Stage 7 of a cutaway: the paper's equation. A plain volume rendering has no use for it.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/passes/Steps.h"
#include "rendering/scene/Scene.h"

namespace fenestra {

class CompositePass {
 public:
  explicit CompositePass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : programs_("Composite.comp", programs) {}
  /// Null leaves out what the scene does not use.
  struct Inputs {
    const gl::Texture& focusLayer;
    const gl::Texture& hitPoints;
    const gl::Texture& distances;
    glm::dvec2 widths;                          ///< w_open, w_border in rendered pixels
    const gl::Texture* contextLayer = nullptr;  ///< with silhouette
    const gl::Texture* silhouette = nullptr;
    double leastLine = -1.0;                      ///< ContextLinesPass::leastStrength()
    const gl::Texture* editMap = nullptr;         ///< of brush strokes
    const gl::Texture* protectedLayer = nullptr;  ///< in front of the focus layer
    const gl::Texture* faintLayer = nullptr;      ///< all that is removed, between the two, as stagesOf() has it
    const gl::Texture* lensSurface = nullptr;     ///< with faintLayer, where stagesOf() has a lens: of LensPass
    const gl::Texture* rayStart = nullptr;        ///< where another camera cuts the opening; see RemovedPass
    bool scattered = false;                       ///< of rays between pixel centres; see RayFrame
  };
  /// Writes premultiplied RGBA32F without background.
  void run(Steps& steps, const GpuScene& gpu, const Inputs& inputs, const Look& look, Regions regions,
           gl::Texture& picture);

 private:
  gl::ShaderVariants programs_;
};

}  // namespace fenestra
