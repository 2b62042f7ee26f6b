#pragma once
// What ClearView's lens reads of the context's first surface (rendering/methods/clearview/ClearView.h has the formula,
// and its source).

#include <optional>

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/passes/HitPointPass.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

/// Finds the lens's middle and how the surface lies around it. Neither the lens's radius nor its other numbers count
/// here: CompositePass weights by them, so that a slider which moves them runs that pass alone.
class LensPass {
 public:
  explicit LensPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : hitPointPass_(programs), programs_("Lens.comp", programs) {}
  /// Reads `hitPoints` (RG32F) and `gpu`'s derivative volume. Writes `surface` (RGBA32F): the surface's unit normal
  /// along the view's right, up and forward, from the gradient of the reconstruction that the context layer has, 0
  /// where there is none; and its distance in mm from the lens's middle, `nothing` where there is no surface before the
  /// focus. `focusMiddle` is in world space.
  void run(Steps& steps, const GpuScene& gpu, const RayFrame& rays, const gl::Texture& hitPoints,
           glm::dvec3 focusMiddle, Regions regions, gl::Texture& surface);
  std::size_t bytes() const { return sightHit_ ? sightHit_.bytes() : 0; }
  /// Drops the image of the line of sight.
  void release() { sightHit_ = {}; }

 private:
  HitPointPass hitPointPass_;
  gl::ShaderVariants programs_;
  std::optional<RayFrame> sight_;  ///< the line of sight to the focus's middle, a picture of one pixel
  gl::Texture sightHit_;           ///< RG32F, its hits
};

}  // namespace fenestra
