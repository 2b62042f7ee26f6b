#pragma once
// S. Bruckner, S. Grimm, A. Kanitsar, M. E. Gröller: Illustrative context-preserving exploration of volume data, IEEE
// TVCG 12(6), 2006.
//
// The context's extinction κ is multiplied by m (MethodStages::Fading): at t mm along a ray, A the opacity of what lies
// before,
//
//   A' = (1 - A) κ m,  C' = (1 - A) κ m c shade,   A = C = 0 where the ray enters
//   m = g^((reach · s · (1 - d) · (1 - A))^sharpness)   in the context, x^0 = 1 for any x;   1 in the focus
//
// which is the limit of its authors' α · m for short steps, α the opacity of one. A counts all before, the focus
// too.
//
//   g = min(‖∇f‖ / steepestSlope(), 1)
//   s = min(diffuse |n·l| + specular |n·h|^shininess, 1) as Lighting.h has it for the context, faded towards the light
//       of average orientation where the normal is uncertain, without ambient light, caps and occlusion; 1 without
//       shading
//   d = the distance from the eye, or from the plane of the eye, 0 to 1 over the volume's bounding sphere, or over
//       what of it lies before the eye (EyeRange)
//
// ∇f is the world gradient by central differences at the voxels, one-sided at the border and trilinear between, or
// the spline's own.

#include "rendering/vocabulary/MethodStages.h"
#include "rendering/vocabulary/Setting.h"

namespace fenestra {

namespace methods {

struct ContextPreserving {
  static constexpr const char* word = "context-preserving";
  static constexpr const char* name = "Context-preserving";
  static constexpr const char* description =
      "Nothing is cut away: what is flat, brightly lit and near to you fades, while edges stay, so that the inside "
      "shows; what is in focus stays as it is (Bruckner, Grimm, Kanitsar and Gröller 2006)";

  /// κt and κs. Its authors name no defaults; these are those of CAMPVis, an implementation by TU München.
  double reach = 3.0;      ///< 0 to 100; 0 fades nothing
  double sharpness = 0.5;  ///< 0.05 to 4

  MethodStages stages() const {
    MethodStages stages = MethodStages::withoutOpening();
    stages.fading = {.reach = reach, .sharpness = sharpness};
    return stages;
  }
  bool operator==(const ContextPreserving&) const = default;
};

}  // namespace methods

template <>
inline constexpr std::tuple settingsOf<methods::ContextPreserving>{
    Setting(&methods::ContextPreserving::reach,
            {.key = "fade_reach",
             .option = "--fade-reach",
             .name = "Reach",
             .description = "How deep the context-preserving method looks into the volume; 0 fades nothing (κt)",
             .range = {0.0, 100.0},
             .slider = {0.0, 10.0},
             .step = 0.1}),
    Setting(&methods::ContextPreserving::sharpness,
            {.key = "fade_sharpness",
             .option = "--fade-sharpness",
             .name = "Sharpness",
             .description = "How sudden the context-preserving method changes from faded to shown along the line of "
                            "sight: more looks like a cut (κs)",
             .range = {0.05, 4.0},
             .slider = {0.1, 2.0},
             .step = 0.05})};

}  // namespace fenestra
