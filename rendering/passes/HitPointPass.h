#pragma once
// Stage 1: first context-or-focus hit and first focus hit of every ray.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/gpu/SceneVariant.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

/// Positions along rays in every map of this renderer are s = t - RayFrame::distance() in mm; `nothing` where there is
/// no such point.
inline constexpr float nothing = -1e30f;
constexpr bool isSomething(float s) { return s > nothing * 0.1f; }

class HitPointPass {
 public:
  explicit HitPointPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : programs_("HitPoints.comp", programs) {}
  /// Writes RG32F (s_context, s_focus) for the pixels from `offset` on, as many as `hitPoints` has.
  void run(Steps& steps, const GpuScene& scene, const RayFrame& rays, gl::Texture& hitPoints,
           glm::ivec2 offset = glm::ivec2(0), HitSurface surface = HitSurface::Exact);
  /// Writes a part of the image, which belongs to scattered rays.
  void run(Steps& steps, const GpuScene& scene, const RayFrame& rays, const gl::Region& region, gl::Texture& hitPoints);

 private:
  void add(Steps& steps, const GpuScene& scene, const RayFrame& rays, const gl::Region& region, gl::Texture& hitPoints,
           glm::ivec2 offset, HitSurface surface);

  gl::ShaderVariants programs_;
};

}  // namespace fenestra
