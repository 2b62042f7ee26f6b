#pragma once
// Stage 4: where each ray starts to see.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/gpu/Schedule.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

/// The focus hit where there is one; within w_open of the focus projection the filled focus hit blended into the
/// context hit by distance; the context hit elsewhere; `nothing` where the ray meets nothing. Then what the brush
/// moved.
class RayStartPass {
 public:
  explicit RayStartPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : programs_("RayStart.comp", programs) {}
  struct Inputs {
    const gl::Texture& hitPoints;
    const gl::Texture& focusFilled;
    const gl::Texture& distances;
    double openWidth;  ///< rendered pixels
    /// For scattered rays, whose hit points these are. The other two textures are those of the picture's pixels,
    /// between which stage 4 is interpolated; greater distances count as `reach`, in rendered pixels.
    double reach = 0.0;
    const gl::Texture* given = nullptr;  ///< R32F: the starts before the brush, in place of what follows from the rest

    /// <starts>, for a picture's rays.
    gl::Choice choice(const RayFrame& rays) const;
    void bind(gl::ShaderProgram& program, const RayFrame& rays) const;
  };
  /// `editMap` is EditMapPass's, or null without strokes. Writes R32F. For scattered rays also `borderDistance`, R32F:
  /// the interpolated distance, 0 on the focus.
  void run(Steps& steps, Schedule schedule, const RayFrame& rays, const Inputs& inputs, const gl::Texture* editMap,
           Regions regions, gl::Texture& rayStart, gl::Texture* borderDistance = nullptr);

 private:
  gl::ShaderVariants programs_;
};

}  // namespace fenestra
