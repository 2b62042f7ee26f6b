#pragma once
// M. Burns, A. Finkelstein: Adaptive cutaways for comprehensible rendering of polygonal scenes, SIGGRAPH Asia 2008.
// rendering/passes/ConePass.h has the formula.

#include "rendering/vocabulary/MethodStages.h"
#include "rendering/vocabulary/Setting.h"

namespace fenestra {

namespace methods {

struct Cone {
  static constexpr const char* word = "cone";
  static constexpr const char* name = "Cone cutaway";
  static constexpr const char* description =
      "A funnel around everything in focus, which widens towards you at one angle: the deeper the focus lies, the "
      "wider the opening (Burns and Finkelstein 2008)";

  double angle = 30.0;  ///< degrees between the axis and the wall of the cones, 1 to 85

  MethodStages stages() const { return MethodStages::onCones(angle, false); }
  bool operator==(const Cone&) const = default;
};

}  // namespace methods

template <>
inline constexpr std::tuple settingsOf<methods::Cone>{
    Setting(&methods::Cone::angle,
            {.key = "cone_angle",
             .option = "--cone-angle",
             .name = "Cone's angle",
             .description = "Angle between the axis and the wall of the cone cutaway's cones: more opens wider",
             .unit = "°",
             .range = {1.0, 85.0},
             .slider = {5.0, 75.0},
             .step = 1.0})};

}  // namespace fenestra
