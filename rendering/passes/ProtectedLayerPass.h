#pragma once
// Stage 5, in front of the focus layer: labels that are never cut away, or all that the opening removes, for methods
// that keep it faint.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/passes/FocusLayerPass.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

/// The opening removes what a ray passes from the context's first hit, s_context, to where it starts to see, s_start.
/// The protected labels stay of this: with κ and c the context's extinction and colour as everywhere else,
///
///   P = ∫ c κ [I ≥ ½] exp(-∫ κ [I ≥ ½] ds') ds   over s_context ≤ s ≤ s_start
///
/// where I is the trilinearly interpolated 0/1 indicator of the protected labels. The picture under the context's edges
/// is P over the focus layer. So a protected vessel crosses the opening as it looks outside of it, and what lies
/// between it and the focus stays removed. Rays that the opening leaves as they are have no P. All that is removed is
/// the same integral without the indicator.
class ProtectedLayerPass {
 public:
  explicit ProtectedLayerPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : programs_("ProtectedLayer.comp", programs) {}
  /// AllWithFocus: where labels in focus are of several levels of importance, what is removed shows those of the lower
  /// ones as they look in focus.
  enum class Shown : std::uint8_t { ProtectedLabels, All, AllWithFocus };
  /// Writes P, premultiplied RGBA32F, cell by cell: within half of the sampling's bound on the error of a colour, or
  /// where it has none, of four times its tolerance. For ProtectedLabels, `gpu` has some.
  void run(Steps& steps, const GpuScene& gpu, const Look& look, const RayFrame& rays,
           const FocusLayerPass::RayStarts& opening, const FocusLayerPass::Sampling& sampling, Regions regions,
           gl::Texture& protectedLayer, const gl::Texture* occlusion = nullptr, Shown shown = Shown::ProtectedLabels);

 private:
  gl::ShaderVariants programs_;
};

}  // namespace fenestra
