#pragma once
// J. Zhou, M. Hinz, K. D. Tönnies: Focal region-guided feature-based volume rendering, 3D Data Processing,
// Visualization and Transmission 2002.
//
// Around the region, the context's extinction is multiplied by m (MethodStages::Fading), which depends on the place
// alone. c is the region's middle, that of the box around the focus (FocusIndex::centre), or of the volume without a
// focus; δ is how many mm a place p lies outside, components along the world's axes; g is the gradient's length as
// context-preserving/ContextPreserving.h has it:
//
//   δ = max(‖p - c‖ - size, 0)       Sphere
//       ‖max(|p - c| - size, 0)‖     Box
//       max(D(p) - size, 0)          Distance; D, mm to the focus, is FocusDistances.h's
//   m = 1 where δ = 0, else g · 2^(-δ / fallOff)   in the context;   1 in the focus
//
// So the region shows as it is, and around it the contours, in proportion to the gradient, the fainter the farther
// outside. Its authors, too, draw contours by the gradient outside of the region; this formula is the program's own.

#include "rendering/vocabulary/MethodStages.h"
#include "rendering/vocabulary/Setting.h"

namespace fenestra {

constexpr auto wordsOf(FocalShape) {
  return std::to_array<Word<FocalShape>>(
      {{FocalShape::Sphere, "sphere", "Sphere", "A ball around the middle of the focus"},
       {FocalShape::Box, "box", "Box", "A cube along the patient's axes, around the middle of the focus"},
       {FocalShape::Distance, "distance", "Distance", "Everything that lies near the focus, whatever its shape"}});
}

namespace methods {

struct FocalRegion {
  static constexpr const char* word = "focal-region";
  static constexpr const char* name = "Focal region";
  static constexpr const char* description =
      "A region around the focus shows as it is; around it only the edges of what is there stay, the fainter the "
      "farther away; what is in focus stays as it is (Zhou, Hinz and Tönnies 2002)";

  FocalShape shape = FocalShape::Sphere;
  double size = 50.0;     ///< mm, 0.1 to 1e5: the radius of the sphere, half the side of the box, the distance
  double fallOff = 50.0;  ///< mm, 0.1 to 1e5: the distance over which what lies outside fades to a half

  /// All that decides on programs.
  FocalRegion programs() const { return {.shape = shape}; }

  MethodStages stages() const {
    MethodStages stages = MethodStages::withoutOpening();
    stages.fading = MethodStages::Fading{.region = MethodStages::Fading::Region{shape, size, fallOff}};
    return stages;
  }
  bool operator==(const FocalRegion&) const = default;
};

}  // namespace methods

template <>
inline constexpr std::tuple settingsOf<methods::FocalRegion>{
    Setting(&methods::FocalRegion::shape,
            {.key = "focal_shape",
             .option = "--focal-shape",
             .name = "Region",
             .description = "Shape of the focal region, around the focus, or around the middle of "
                            "the volume without a focus"}),
    Setting(&methods::FocalRegion::size,
            {.key = "focal_size",
             .option = "--focal-size",
             .name = "Size of region",
             .description = "Radius of the focal region's sphere, half the side of its box, or its "
                            "distance from the focus",
             .unit = "mm",
             .range = {0.1, 1e5},
             .slider = {5.0, 150.0},
             .step = 1.0}),
    Setting(&methods::FocalRegion::fallOff,
            {.key = "focal_fall_off",
             .option = "--focal-fall-off",
             .name = "Fall-off",
             .description = "How far outside of the focal region edges are half as strong as at its border: more shows "
                            "more of what is around it",
             .unit = "mm",
             .range = {0.1, 1e5},
             .slider = {1.0, 200.0},
             .step = 1.0})};

}  // namespace fenestra
