#pragma once
// Labels that are never clipped (Clipping::exempt).

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/passes/FocusLayerPass.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

/// Clipping keeps one stretch of a ray, [s_in, s_out]. Of what lies before and behind it the exempt labels stay: with κ
/// and c the context's extinction and colour, and I the trilinearly interpolated 0/1 indicator of the exempt labels,
///
///   E = ∫ c κ [I ≥ ½] exp(-∫ κ [I ≥ ½] ds') ds
///
/// over the ray up to s_in, and from s_out on; over all of a ray of which nothing is kept. The picture becomes the
/// first over the picture over the second. The opening cuts none of them, and a label in focus shows as the context
/// there.
class ExemptPass {
 public:
  explicit ExemptPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : programs_("Exempt.comp", programs) {}
  /// Writes premultiplied RGBA32F from `picture`, which is the same: cell by cell, each of both parts within a quarter
  /// of the sampling's bound on the error of a colour, or where it has none, of the usual one. `gpu` has exempt labels.
  void run(Steps& steps, const GpuScene& gpu, const Look& look, const RayFrame& rays, const gl::Texture& picture,
           const FocusLayerPass::Sampling& sampling, Regions regions, gl::Texture& exempted,
           const gl::Texture* occlusion = nullptr);

 private:
  gl::ShaderVariants programs_;
};

}  // namespace fenestra
