#pragma once
// The brush: strokes splatted into a view's edit map.

#include "rendering/gl/Buffer.h"
#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/Schedule.h"
#include "rendering/gpu/StrokeLines.h"
#include "rendering/passes/RayStartPass.h"

namespace fenestra {

/// Writes RG32F: how far in mm the strokes move a ray's start (negative towards the eye); and the factor of the context
/// layer's opacity where the ray meets the focus, of the border's elsewhere. 0 and 1 where no stroke acts, or the ray
/// meets nothing.
class EditMapPass {
 public:
  explicit EditMapPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : programs_("EditMap.comp", programs) {}
  void run(Steps& steps, Schedule schedule, const RayFrame& rays, const RayStartPass::Inputs& inputs,
           const ProjectedStrokes& strokes, Regions regions, gl::Texture& editMap);
  std::size_t bytes() const { return strokes_.bytes() + lines_.bytes() + tiles_.bytes(); }
  /// Drops the strokes' buffers.
  void release() {
    strokes_ = {};
    lines_ = {};
    tiles_ = {};
  }

 private:
  gl::ShaderVariants programs_;
  gl::Buffer strokes_, lines_, tiles_;
};

}  // namespace fenestra
