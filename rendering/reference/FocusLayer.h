#pragma once
// Stage 5: the emission-absorption integral along given rays (see Picture.h).

#include <limits>

#include "rendering/reference/Alone.h"
#include "rendering/reference/Reference.h"

namespace fenestra::reference {

class Occlusion;

/// A capped face in grey (Clipping::grey), on which a ray starts.
struct GreyFace {
  WindowLevel window;
  bool showsFocus = false;  ///< not where the ray starts in the focus
};

/// The visible part of a ray, from where the cutaway lets it start.
struct CutRay {
  Ray ray;
  Span span;  ///< from the start to where the ray leaves the box; tIn > tOut: nothing is seen
  /// Where it sees nothing again behind the start; see rendering/passes/RemovedPass.h.
  Span hole{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  glm::dvec3 wall{0.0};     ///< unit normal of the cut or capped face at the start, world; zero where there is none
  bool onFocus = false;     ///< the start is on the focus's surface, on whichever side rounding has put it
  double beforeWall = 0.0;  ///< mm that the start lies behind that face
  /// Set where the context is ghosted: it is a ghost up to this t and in the hole, in which the ray then sees as well.
  /// Minus infinity where no part before the hole is ghosted.
  std::optional<double> ghostedTo{};
  std::optional<GreyFace> grey{};  ///< nothing behind it shows
};

struct FocusLayer {
  std::vector<glm::dvec4> colour;  ///< premultiplied RGBA
  Image error;                     ///< estimated, of the worst channel; at most the tolerance
};

/// The protected labels in what the opening removes: the integral from `tContext` to the start of each ray, of the
/// context alone, where the labels' interpolated 0/1 indicator is ½ or more. One element a ray.
FocusLayer protectedLayer(const Scene& scene, const Camera& camera, const std::vector<CutRay>& rays,
                          const Image& tContext, double tolerance, const Occlusion* occlusion = nullptr);

/// All that the opening removes: that integral of the context without regard to labels.
FocusLayer removedLayer(const Scene& scene, const Camera& camera, const std::vector<CutRay>& rays,
                        const Image& tContext, double tolerance, const Occlusion* occlusion = nullptr);

/// The scene's exempt labels before and behind the part of each ray that clipping keeps; see
/// rendering/passes/ExemptPass.h.
struct ExemptLayers {
  FocusLayer before, behind;
};
ExemptLayers exemptLayers(const Scene& scene, const Camera& camera, const std::vector<CutRay>& rays, double tolerance,
                          const Occlusion* occlusion = nullptr);

FocusLayer layerOf(Alone shown, const Scene& scene, const Camera& camera, const std::vector<CutRay>& rays,
                   double tolerance);

/// One element a ray. `occlusion`, here and above: null without ambient occlusion and shadows.
FocusLayer focusLayer(const Scene& scene, const Camera& camera, const std::vector<CutRay>& rays, double tolerance,
                      const Occlusion* occlusion = nullptr);

}  // namespace fenestra::reference
