#pragma once
// Stages 5 to 7 and the finished picture in double precision on the CPU: the limit that the renderer's colours converge
// to. Shares the lighting model's numbers with the shaders (rendering/scene/Lighting.h) and no code. Uses all cores.
//
// Colour is the emission-absorption integral along each pixel's ray (Max, TVCG 1995, equation 5),
//   C = ∫ T(t) κ(f(t)) c(f(t)) shade(t) dt,  T(t) = exp(-∫ κ dt),  A = 1 - T(t_out),
// with f the reconstruction of the voxels' values (trilinear, or a spline; see Field.h), κ and c the piecewise linear
// transfer function itself. Each ray is cut at cell faces, where f meets a node of the transfer function and at the
// surface of the focus; in between κ is a polynomial, so optical depth is exact, and colour is integrated by
// Gauss-Kronrod rules that halve their interval until the tolerance is met.
//
// Where the look's edges are smooth, the finished picture is the mean of five rays in the pixels that edges run
// through, as rendering/scene/EdgeRays.h defines it; the layers stay those of the rays through the pixels' centres.
//
// NaN and infinite values count as in hitPoints().

#include <vector>

#include "rendering/reference/Reference.h"

namespace fenestra::reference {

struct PictureOptions {
  double pixelScale = 1.0;  ///< rendered pixels per device-independent pixel (see View)
  double tolerance = 1e-5;  ///< greatest estimated error of a channel of the focus layer, on the scale of 0..1; > 0
  /// The pixels to make, (i, j) from the top left; empty: all of them, row by row. Stages 1 to 4 are always whole: the
  /// opening around a pixel depends on the others.
  std::vector<glm::ivec2> pixels;
  ShownSlices slices{};  ///< of walls
};

/// One element a pixel, in the order of PictureOptions::pixels.
struct Picture {
  std::vector<glm::dvec4> focusLayer;      ///< premultiplied RGBA
  std::vector<glm::dvec4> faintLayer;      ///< premultiplied RGBA of all that the opening removes; empty unless it stays faint
  std::vector<glm::dvec4> protectedLayer;  ///< premultiplied RGBA, in front of it; empty without an opening or protected labels
  /// κ1 ≥ κ2 (1/mm, positive where the surface bends away from lower values), illumination, value (real units); NaN
  /// where there is no surface to draw. Empty when the scene has no context layer.
  std::vector<glm::dvec4> contextLayer;
  /// Where a lens shows a part of what is removed: the surface's normal along the view's axes, 0 where it has none, and
  /// its distance in mm from the lens's middle, NaN where there is no surface. Empty without a lens.
  std::vector<glm::dvec4> lens;
  std::vector<glm::dvec4> walls;  ///< premultiplied RGBA of slices that stand as walls; empty without any
  Image silhouette;               ///< 1 - |n·v| of the context layer, NaN and empty as that is
  std::vector<glm::dvec4> final;  ///< premultiplied RGBA, without background
  /// Estimated error of the worst channel of the focus layer, at most the tolerance; the final picture's is no greater.
  Image error;
};

/// The whole chain. With no cutaway (see hasCutaway) it is a plain volume rendering from the box's entry on.
Picture picture(const Scene& scene, const Camera& camera, glm::ivec2 size, const PictureOptions& options = {});

/// The scene as a view's picture shows it: without smooth edges where the view has none (hasSmoothEdges).
Scene asDrawn(Scene scene, const View& view);

/// The picture of a view, whose opening may be frozen or have an axis offset, and which may have no smooth edges.
/// `tolerance` as in PictureOptions.
Picture picture(const Scene& scene, const View& view, double tolerance = 1e-5);

/// The picture from given stages 1 to 4. With another renderer's, only its errors of stages 5 to 7 remain in a
/// comparison. Needs tContext, tFocus and tStart, and tOut where the scene has strokes; nothing when the scene has no
/// cutaway.
Picture picture(const Scene& scene, const Camera& camera, glm::ivec2 size, const Stages& stages,
                const PictureOptions& options = {});

}  // namespace fenestra::reference
