#pragma once
// S. Bruckner, M. E. Gröller: Exploded views for volume data, IEEE TVCG 12(5) (IEEE Visualization), 2006.
// rendering/scene/Explosion.h has the formula.

#include "rendering/vocabulary/MethodStages.h"
#include "rendering/vocabulary/Setting.h"

namespace fenestra {

/// How many planes cut the volume into parts.
enum class ExplosionPlanes : std::uint8_t { One, Two, Three };
constexpr auto wordsOf(ExplosionPlanes) {
  return std::to_array<Word<ExplosionPlanes>>(
      {{ExplosionPlanes::One, "one", "Two halves", "One plane cuts the volume into left and right"},
       {ExplosionPlanes::Two, "two", "Four quarters", "Two planes: left and right, above and below"},
       {ExplosionPlanes::Three, "three", "Eight parts",
        "Three planes: left and right, above and below, front and back"}});
}

constexpr auto wordsOf(ExplosionAxes) {
  return std::to_array<Word<ExplosionAxes>>(
      {{ExplosionAxes::Patient, "patient", "The patient",
        "Planes along the patient's axes: left and right are the patient's"},
       {ExplosionAxes::View, "view", "The view", "Planes along the picture's axes, which turn with the camera"}});
}

namespace methods {

struct Explode {
  static constexpr const char* word = "explode";
  static constexpr const char* name = "Exploded view";
  static constexpr const char* description =
      "What is around the focus is cut into parts, which move apart and out of your line of sight to it; what is in "
      "focus stays in its place (Bruckner and Gröller 2006)";

  double degree = 0.5;  ///< of explosion: 0, all parts in their places, to 1
  ExplosionPlanes planes = ExplosionPlanes::Two;
  ExplosionAxes axes = ExplosionAxes::Patient;

  MethodStages stages() const {
    MethodStages stages = MethodStages::withoutOpening();
    if (degree > 0.0) stages.explosion = {degree, 1 + static_cast<int>(planes), axes};
    return stages;
  }
  bool operator==(const Explode&) const = default;
};

}  // namespace methods

template <>
inline constexpr std::tuple settingsOf<methods::Explode>{
    Setting(&methods::Explode::degree,
            {.key = "explosion",
             .option = "--explosion",
             .name = "Explosion",
             .description = "How far the parts of an exploded view are moved apart (its degree of "
                            "explosion): at 0 all are in their places",
             .range = fraction,
             .step = 0.05}),
    Setting(&methods::Explode::planes,
            {.key = "explosion_planes",
             .option = "--explosion-planes",
             .name = "Parts",
             .description = "How many planes through the middle of the focus, or of the volume without a focus, cut "
                            "it into the parts of an exploded view"}),
    Setting(&methods::Explode::axes, {.key = "explosion_axes",
                                      .option = "--explosion-axes",
                                      .name = "Cut along",
                                      .description = "Whether the planes of an exploded view lie along the patient's "
                                                     "axes or the view's"})};

}  // namespace fenestra
