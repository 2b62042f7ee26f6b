#pragma once
// Stage 5: the volume rendering integral from the ray start on, focus and context each with their own properties.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/passes/GpuScene.h"
#include "rendering/passes/RayFrame.h"

namespace fenestra {

class FocusLayerPass {
 public:
  /// Writes premultiplied RGBA32F. `rayStart` null: rays start where they enter the volume. `step` in mm.
  void run(const GpuScene& gpu, const Scene& scene, const RayFrame& rays, const gl::Texture* rayStart, double step,
           gl::Texture& focusLayer);

 private:
  gl::ShaderVariants programs_{"FocusLayer.comp"};
};

}  // namespace fenestra
