#pragma once
// J. Krüger, J. Schneider, R. Westermann: ClearView: An interactive context preserving hotspot visualization technique,
// IEEE Visualization 2006.
//
// The lens decides on w of MethodStages for each pixel. With P the place where the ray meets the context's first
// surface, and n the surface's normal in the view's axes, or 0 where it has none,
//
//   κ = ‖Σ |n_i - n|‖     over the four pixels beside, those beyond the picture left out, |·| of each component
//   d = ‖P - middle‖ / radius
//   b = clamp(d, 0, 1)                                            Distance
//       0 where d < 1, else 1                                     Curvature
//       clamp((t_focus - t_context) / radius, 0, 1) where d < 1, else 1; t_focus infinite beside the focus   Depth
//   w = clamp(max(κ · bends, b), 0, 1)
//
// The middle is where the line of sight to the middle of the focus (FocusIndex::centre), or to the crosshair, first
// meets context or focus, as a pick there would be; that point itself where the line meets nothing, or it lies
// behind the eye. Where the ray meets the focus within half the finest spacing of the context, there is no surface:
// w = 1. A surface has no normal this near to where its ray enters the volume, or what clips it. The context layer's
// opacity is multiplied by 1 - w, because it shows edges of what was removed. At last the line around the lens
// darkens the premultiplied picture of opacity A wherever there is a surface, as far as the brush does not fade it:
//
//   C := max(C - A · ½ (1 - clamp(|d - 1| · rim, 0, 1)), 0)

#include "rendering/vocabulary/MethodStages.h"
#include "rendering/vocabulary/Setting.h"

namespace fenestra {

constexpr auto wordsOf(LensPlace) {
  return std::to_array<Word<LensPlace>>(
      {{LensPlace::OverFocus, "focus", "Focus", "The middle of the focus"},
       {LensPlace::OverCrosshair, "crosshair", "Crosshair", "The crosshair: the lens follows what you point at"}});
}

constexpr auto wordsOf(LensFade) {
  return std::to_array<Word<LensFade>>(
      {{LensFade::Distance, "distance", "To the rim", "The nearer to the lens's rim, the more of what hides the focus"},
       {LensFade::Curvature, "curvature", "Evenly", "Nothing but the bends of what hides the focus"},
       {LensFade::Depth, "depth", "With depth", "The more lies in front of the focus, the more of it"}});
}

namespace methods {

struct ClearView {
  static constexpr const char* word = "clearview";
  static constexpr const char* name = "ClearView";
  static constexpr const char* description =
      "A lens over the focus through which it shows, while what hides it fades towards the lens's middle and stays "
      "where it bends (Krüger, Schneider and Westermann 2006)";

  LensFade fade = LensFade::Distance;
  LensPlace place = LensPlace::OverFocus;
  /// % of the volume's longest side, 0.1 to 1000: 100 by what ClearView's authors call the lens's size, in units of one
  /// divided by the longest side of the volume. Theirs is 5.5.
  double radius = 18.2;
  double bends = 1.0;  ///< contextScale of ClearView's authors, 0 to 100
  double rim = 60.0;   ///< border of ClearView's authors, 1 to 1000

  MethodStages stages() const {
    MethodStages stages;
    stages.hasWidth = stages.hasBorder = false;
    stages.lens = {place, fade, 0.01 * radius, bends, rim};
    return stages;
  }
  bool operator==(const ClearView&) const = default;
};

}  // namespace methods

template <>
inline constexpr std::tuple settingsOf<methods::ClearView>{
    Setting(&methods::ClearView::fade,
            {.key = "lens_fade",
             .option = "--lens-fade",
             .name = "Lens keeps",
             .description = "What stays within ClearView's lens of what hides the focus, beside its "
                            "bends"}),
    Setting(&methods::ClearView::place, {.key = "lens_place",
                                         .option = "--lens-place",
                                         .name = "Lens over",
                                         .description = "What ClearView's lens lies over, as you see it"}),
    Setting(&methods::ClearView::radius,
            {.key = "lens_radius",
             .option = "--lens-radius",
             .name = "Lens",
             .description = "Radius of ClearView's lens, as a share of the volume's longest side; its authors use 18.2",
             .unit = "%",
             .range = {0.1, 1000.0},
             .slider = {2.0, 60.0},
             .step = 0.2}),
    Setting(&methods::ClearView::bends,
            {.key = "lens_bends",
             .option = "--lens-bends",
             .name = "Bends kept",
             .description = "How much of the bends of what hides the focus stays within ClearView's lens; 0 keeps none",
             .range = {0.0, 100.0},
             .slider = {0.0, 4.0},
             .step = 0.1}),
    Setting(&methods::ClearView::rim,
            {.key = "lens_rim",
             .option = "--lens-rim",
             .name = "Rim of the lens",
             .description = "How thin the dark line around ClearView's lens is: more is thinner",
             .range = {1.0, 1000.0}})};

}  // namespace fenestra
