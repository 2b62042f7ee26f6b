#pragma once
// M. J. McGuffin, L. Tancau, R. Balakrishnan: Using deformations for browsing volumetric data, IEEE Visualization 2003;
// that the focus is left out of the deformation: C. D. Correa, D. Silver, M. Chen: Feature aligned volume manipulation
// for illustration and visualization, IEEE TVCG 12(5), 2006. rendering/scene/Peel.h has the formula.

#include "rendering/vocabulary/MethodStages.h"
#include "rendering/vocabulary/Setting.h"

namespace fenestra {

constexpr auto wordsOf(PeelSide) {
  return std::to_array<Word<PeelSide>>({{PeelSide::Anterior, "anterior", "The front", "The patient's anterior side"},
                                        {PeelSide::Posterior, "posterior", "The back", "The patient's posterior side"},
                                        {PeelSide::Left, "left", "The left", "The patient's left side"},
                                        {PeelSide::Right, "right", "The right", "The patient's right side"},
                                        {PeelSide::Superior, "superior", "Above", "The patient's superior side"},
                                        {PeelSide::Inferior, "inferior", "Below", "The patient's inferior side"}});
}

namespace methods {

struct Peel {
  static constexpr const char* word = "peel";
  static constexpr const char* name = "Peeling";
  static constexpr const char* description =
      "A layer in front of the focus is cut in two, and its halves are rolled aside like a peel; what is in focus "
      "stays in its place (McGuffin et al. 2003; Correa et al. 2006)";

  double amount = 1.0;  ///< 0, the layer lies in its place, to 1, nothing of it lies before the focus
  PeelSide side = PeelSide::Anterior;
  double turn = 0.0;     ///< degrees, -180 to 180, of the cut around the side's axis
  double depth = 0.5;    ///< 0, the layer ends just before the focus, to 1, just behind it
  double radius = 15.0;  ///< mm, 1 to 1000: of the hollow in the roll
  double margin = 10.0;  ///< mm, 0 to 1e5: how far the opening reaches beyond the focus

  MethodStages stages() const {
    MethodStages stages = MethodStages::withoutOpening();
    if (amount > 0.0) stages.peel = {amount, side, turn, depth, radius, margin};
    return stages;
  }
  bool operator==(const Peel&) const = default;
};

}  // namespace methods

template <>
inline constexpr std::tuple settingsOf<methods::Peel>{
    Setting(&methods::Peel::amount,
            {.key = "peel",
             .option = "--peel",
             .name = "Peeled",
             .description = "How far the layer in front of the focus is peeled away: at 0 it lies in "
                            "its place, at 1 none of it lies in front of the focus",
             .range = fraction,
             .step = 0.05}),
    Setting(&methods::Peel::side, {.key = "peel_side",
                                   .option = "--peel-side",
                                   .name = "Peel off",
                                   .description = "Which side of the patient the layer is peeled off"}),
    Setting(&methods::Peel::turn,
            {.key = "peel_turn",
             .option = "--peel-turn",
             .name = "Cut turned by",
             .description = "Turns the cut through the layer: at 0 it runs from head to foot, or from front to back "
                            "where the layer is peeled off above or below",
             .unit = "°",
             .range = {-180.0, 180.0},
             .slider = {-90.0, 90.0},
             .step = 5.0}),
    Setting(&methods::Peel::depth,
            {.key = "peel_depth",
             .option = "--peel-depth",
             .name = "Layer down to",
             .description = "How deep the layer reaches: at 0 it ends just in front of the focus, at 1 just behind it",
             .range = fraction,
             .step = 0.05}),
    Setting(&methods::Peel::radius,
            {.key = "peel_radius",
             .option = "--peel-radius",
             .name = "Roll",
             .description = "Radius of the hollow in the roll: less rolls the layer up more tightly",
             .unit = "mm",
             .range = {1.0, 1000.0},
             .slider = {1.0, 100.0},
             .step = 1.0}),
    Setting(&methods::Peel::margin,
            {.key = "peel_margin",
             .option = "--peel-margin",
             .name = "Margin",
             .description = "How far the opened window reaches beyond the focus on all its sides",
             .unit = "mm",
             .range = {0.0, 1e5},
             .slider = {0.0, 100.0},
             .step = 1.0})};

}  // namespace fenestra
