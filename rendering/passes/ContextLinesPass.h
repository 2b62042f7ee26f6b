#pragma once
// Finds the least strength of the context's edges that are drawn over the focus (rendering/scene/ContextLines.h).

#include "rendering/gl/Buffer.h"
#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/Uniforms.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

class ContextLinesPass {
 public:
  explicit ContextLinesPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : programs_("ContextLines.comp", programs) {}
  /// Reads what ContextLayerPass writes. `regions` hold the focus's projection and do not overlap. leastStrength() is
  /// that of the picture when the steps are done; they wait for the device.
  void run(Steps& steps, const GpuScene& gpu, const ContextLayer& look, const gl::Texture& hitPoints,
           const gl::Texture& contextLayer, const gl::Texture& silhouette, Regions regions);
  double leastStrength() const { return leastStrength_; }
  std::size_t bytes() const { return counts_.bytes(); }
  void release() { counts_ = {}; }

 private:
  gl::ShaderVariants programs_;
  gl::Buffer counts_;  ///< of shaders/ContextLines.comp
  double leastStrength_ = 0.0;
};

/// What shaders read of a layer's look. `leastStrength`: lines::all keeps every edge.
ContextLayerUniforms uniformsOf(const ContextLayer& layer, const DerivativeVolume& derivative, double leastStrength);

}  // namespace fenestra
