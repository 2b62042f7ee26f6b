#pragma once
// S. Bruckner, M. E. Gröller: VolumeShop: An interactive system for direct volume illustration, IEEE Visualization
// 2005.
//
// The context's extinction is multiplied by m (MethodStages::Fading). m is less than 1 only where the opening removes
// something, before the ray's start: on rays that meet the focus, and on those that start behind the context's first
// surface; where another camera cuts the opening, also in the hole behind that (rendering/passes/RemovedPass.h). There,
// with v the ray's direction and ∇f as context-preserving/ContextPreserving.h has it, its length not limited to 1,
//
//   e = (‖∇f‖² - outline · (∇f·v)²) / (‖∇f‖² + edge²)        0 for a volume of one value
//   m = 1 - strength · (1 - e)   in the context;   1 in the focus
//
// ∇f in units of steepestSlope(). So what is flat gives way, edges stay, and with `outline` those that face the eye
// give way in favour of those seen from the side: 1 - (n·v)² of them stays. A quotient of polynomials along the ray
// has no kink where a gradient is 0, saturates, or is seen edge on. Its authors, too, keep a selection in sight by
// ghosting what lies before it, and let edges decide what stays of that. This formula is the program's own, and so
// is the shape of the ghost: it fills the opening that rises from the selection to the surface around it.

#include "rendering/vocabulary/MethodStages.h"
#include "rendering/vocabulary/Setting.h"

namespace fenestra {

namespace methods {

struct Selection {
  static constexpr const char* word = "selection";
  static constexpr const char* name = "Ghosted selection";
  static constexpr const char* description =
      "Nothing is cut away: in front of the focus, and in the opening around it, what is flat gives way and edges "
      "stay, like a ghost of it; what is in focus stays as it is (Bruckner and Gröller 2005)";

  double strength = 1.0;  ///< 0..1: the share of what is flat that gives way; 0 fades nothing
  double edge = 10.0;     ///< % of the steepest gradient, 0.01 to 1000: half of it stays
  double outline = 0.5;   ///< 0..1: the share of edges that face the eye that gives way, too

  MethodStages stages() const {
    MethodStages stages;
    stages.fading = MethodStages::Fading{.ghost = MethodStages::Fading::Ghost{strength, 0.01 * edge, outline}};
    return stages;
  }
  bool operator==(const Selection&) const = default;
};

}  // namespace methods

template <>
inline constexpr std::tuple settingsOf<methods::Selection>{
    Setting(&methods::Selection::strength,
            {.key = "ghost_strength",
             .option = "--ghost-strength",
             .name = "Ghosting",
             .description = "How much of what is flat in front of the selection gives way; 0 fades nothing",
             .range = fraction,
             .step = 0.05}),
    Setting(&methods::Selection::edge,
            {.key = "ghost_edge",
             .option = "--ghost-edge",
             .name = "Edges from",
             .description = "Gradient of which half stays in front of the selection, as a share of the steepest that "
                            "the volume can have: less keeps fainter edges",
             .unit = "%",
             .range = {0.01, 1000.0},
             .slider = {0.5, 50.0},
             .step = 0.5}),
    Setting(&methods::Selection::outline,
            {.key = "ghost_outline",
             .option = "--ghost-outline",
             .name = "Outlines",
             .description = "How much edges that face you give way, too, so that outlines stay in front of the "
                            "selection",
             .range = fraction,
             .step = 0.05})};

}  // namespace fenestra
