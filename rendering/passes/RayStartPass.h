#pragma once
// Stage 4: where each ray starts to see.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/passes/RayFrame.h"

namespace fenestra {

/// The focus hit where there is one; within w_open of the focus projection the filled focus hit blended into the
/// context hit by distance; the context hit elsewhere; `nothing` where the ray meets nothing.
class RayStartPass {
 public:
  /// `openWidth` in rendered pixels. Writes R32F.
  void run(const RayFrame& rays, const gl::Texture& hitPoints, const gl::Texture& focusFilled,
           const gl::Texture& distances, double openWidth, gl::Texture& rayStart);

 private:
  gl::ShaderVariants programs_{"RayStart.comp"};
};

}  // namespace fenestra
