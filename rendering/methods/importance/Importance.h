#pragma once
// I. Viola, A. Kanitsar, M. E. Gröller: Importance-driven volume rendering, IEEE Visualization 2004.
// rendering/scene/Importance.h has the formula for several levels of importance, and rendering/passes/ConePass.h that
// of the cones. Where the context stays faint, MethodStages::faintOpacity says how.

#include "rendering/vocabulary/MethodStages.h"
#include "rendering/vocabulary/Setting.h"

namespace fenestra {

/// Maximum importance projection removes what hides the focus, in cones that widen towards the eye. Average importance
/// compositing keeps it, faintly, on the rays that meet the focus.
enum class ImportanceMode : std::uint8_t { Maximum, Average };
constexpr auto wordsOf(ImportanceMode) {
  return std::to_array<Word<ImportanceMode>>(
      {{ImportanceMode::Maximum, "maximum", "Removed",
        "What hides the focus is removed, in a cone that widens from the focus's outline towards you (maximum "
        "importance "
        "projection)"},
       {ImportanceMode::Average, "average", "Faint",
        "What hides the focus stays, but faint (average importance compositing)"}});
}

constexpr auto wordsOf(Sparseness) {
  return std::to_array<Word<Sparseness>>(
      {{Sparseness::Opacity, "opacity", "See-through", "Less opaque, in its own colours"},
       {Sparseness::Colour, "colour", "Grey", "Less opaque, and grey, so that the colours are the focus's alone"},
       {Sparseness::ScreenDoor, "screen-door", "Dotted",
        "As it is on a few pixels in an even pattern, and left out on the others"}});
}

namespace methods {

struct Importance {
  static constexpr const char* word = "importance";
  static constexpr const char* name = "Importance-driven";
  static constexpr const char* description =
      "What hides the focus gives way to it because the focus is more important: it is removed, or stays faint (Viola, "
      "Kanitsar and Gröller 2004)";

  ImportanceMode mode = ImportanceMode::Maximum;
  double angle = 15.0;    ///< degrees, of the cones of Maximum, 1 to 85; 15 is its authors'
  double opacity = 0.05;  ///< of Average: the factor of the opacity of what lies before the focus, 0..1
  Sparseness sparseness = Sparseness::Opacity;  ///< of Average

  /// All that decides on programs.
  Importance programs() const { return {.mode = mode, .sparseness = sparseness}; }

  MethodStages stages() const {
    MethodStages stages;
    if (mode == ImportanceMode::Maximum) stages = MethodStages::onCones(angle, true);
    stages.hasLevels = true;
    if (mode == ImportanceMode::Maximum) return stages;
    stages.hasWidth = false;
    stages.faintOpacity = opacity;
    stages.sparseness = sparseness;
    return stages;
  }
  bool operator==(const Importance&) const = default;
};

}  // namespace methods

template <>
inline constexpr std::tuple settingsOf<methods::Importance>{
    Setting(&methods::Importance::mode,
            {.key = "importance",
             .option = "--importance",
             .name = "What hides the focus",
             .description = "What the importance-driven method does with what hides the focus"}),
    Setting(
        &methods::Importance::angle,
        {.key = "importance_angle",
         .option = "--importance-angle",
         .name = "Widening",
         .description = "Angle at which the importance-driven opening widens from the focus's outline towards the eye",
         .unit = "°",
         .range = {1.0, 85.0},
         .slider = {1.0, 60.0},
         .step = 1.0}),
    Setting(
        &methods::Importance::opacity,
        {.key = "importance_opacity",
         .option = "--importance-opacity",
         .name = "Opacity left",
         .description = "Factor of the opacity of what hides the focus, where the importance-driven method keeps it "
                        "faint; 0 removes it",
         .range = fraction,
         .step = 0.05}),
    Setting(&methods::Importance::sparseness, {.key = "sparseness",
                                               .option = "--importance-sparseness",
                                               .name = "Faint how",
                                               .description = "How what hides the focus is made faint"})};

}  // namespace fenestra
