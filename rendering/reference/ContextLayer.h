#pragma once
// Stage 6: the context's first surface, from derivatives of a C² reconstruction (Kindlmann, Whitaker, Tasdizen, Möller,
// Vis 2003): the cubic B-spline over the volume smoothed by (1 3 3 1)/8 and thinned by two along each axis that is
// finer than twice the finest spacing and has at least eight voxels.

#include <optional>

#include "rendering/reference/Reference.h"

namespace fenestra::reference {

/// The context layer's quantities at one pixel.
struct ContextPoint {
  double k1 = 0.0, k2 = 0.0;  ///< 1/mm, k1 ≥ k2; positive where the surface bends away from lower values
  double illumination = 0.0;
  double value = 0.0;       ///< real
  double silhouette = 0.0;  ///< 1 - |n·v|
};

/// One element a ray: at `tContext`, where that is a surface of its own, more than half the finest spacing behind the
/// box's entry and before `tFocus`, and has a gradient. Beside the volume's faces, curvatures and silhouette fade: they
/// are 0 where the spline takes values from beyond a face, and whole one element of the smoothed volume further in. An
/// axis of fewer than eight elements does not count.
std::vector<std::optional<ContextPoint>> contextLayer(const Scene& scene, const Camera& camera,
                                                      const std::vector<Ray>& rays, const Image& tContext,
                                                      const Image& tFocus);

/// One element a ray: the unit gradient there, in world space; 0 where `tContext` is no surface of its own, as above,
/// or has no gradient. The ray need not meet the focus.
std::vector<glm::dvec3> contextNormals(const Scene& scene, const std::vector<Ray>& rays, const Image& tContext,
                                       const Image& tFocus);

/// Strength of a point's edge (rendering/scene/ContextLines.h). `scale`: derivativeSpacing().
double strengthOf(const ContextLayer& look, const ContextPoint& point, double scale);
/// Opacity of the context layer there: both terms rise steeply, so that edges come out as lines. `factor` is the
/// brush's, `leastLine` the least strength that shows.
double contextOpacity(const ContextLayer& look, const ContextPoint& point, double scale, double factor,
                      double leastLine);
/// Its colour, of the context's function `context`.
glm::dvec3 contextColour(const ContextLayer& look, const TransferFunction& context, const ContextPoint& point);

/// The length in mm that makes curvature dimensionless: the finest spacing of the smoothed volume.
double derivativeSpacing(const Grid& grid);

}  // namespace fenestra::reference
