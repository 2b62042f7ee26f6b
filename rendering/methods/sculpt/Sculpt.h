#pragma once
// What the user carves out of the volume is the opening: S. W. Wang, A. E. Kaufman: Volume sculpting, Symposium on
// Interactive 3D Graphics 1995. rendering/settings/Removal.h has the tools.

#include "rendering/vocabulary/MethodStages.h"

namespace fenestra {

namespace methods {

struct Sculpt {
  static constexpr const char* word = "sculpt";
  static constexpr const char* name = "Sculpting";
  static constexpr const char* description =
      "Nothing opens by itself: you carve the volume with a ball, a box or a saw until the focus shows (Wang and "
      "Kaufman 1995)";
  static constexpr bool carves = true;  ///< by the user's tools

  MethodStages stages() const { return MethodStages::withoutOpening(); }
  bool operator==(const Sculpt&) const = default;
};

}  // namespace methods

}  // namespace fenestra
