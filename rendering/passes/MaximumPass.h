#pragma once
// Maximum intensity projection of the context, beneath the focus layer.

#include <algorithm>

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/passes/FocusLayerPass.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

/// Maximum intensity projection after J. W. Wallis, T. R. Miller, C. A. Lerner, E. C. Kleerup: Three-dimensional
/// display in nuclear medicine, IEEE Transactions on Medical Imaging 8(4), 1989: a ray shows the greatest value on it.
/// Here
///
///   V = max { f(r(t)) : t_start ≤ t ≤ t_out, r(t) is context }
///   A = 1 - exp(-κ(V) · thickness),   M = (c(V) A, A)        κ, c: the context's transfer function
///   F + (1 - A_F) M                                          F, of opacity A_F: the focus layer, of the focus alone
///
/// Context is what is not focus and has an opacity above 1/255 over 1 mm: values that do not show are no candidates.
/// Where such values end, V may be the end, and M what the function tends to from there on downwards.
/// With functions of labels (FaintLabels.h), that of the place where V is. M is 0 where a ray meets no context. It has
/// no light. Where another camera cuts the opening, the hole behind the start is left out (RemovedPass.h).
///
/// A stretch of a ray up to hair() long shows nothing: rounding decides whether there is one.
///
/// Along a ray f is a cubic in each cell: its greatest value is at an end of a part that is context, or where its slope
/// is 0. For a spline, f is trilinear between the samples of the refined grid.
///
/// Colour and opacity by the value at the greatest instead of a grey window are this program's own, and so is the layer
/// of even thickness that they are taken of.
class MaximumPass {
 public:
  /// mm: the exactness of hits.
  static double hair(const Grid& grid) { return 2e-3 * std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z}); }
  explicit MaximumPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : programs_("Maximum.comp", programs) {}
  /// Writes F + (1 - A_F) M, premultiplied RGBA32F. `opening`: null where rays start where they enter the volume. Rays
  /// with 1 - A_F below `leastTransmittance` are taken to show F alone.
  void run(Steps& steps, const GpuScene& gpu, const MethodStages::Maximum& maximum, const RayFrame& rays,
           const std::optional<FocusLayerPass::RayStarts>& opening, const gl::Texture& focusLayer,
           double leastTransmittance, Regions regions, gl::Texture& picture);

 private:
  gl::ShaderVariants programs_;
};

}  // namespace fenestra
