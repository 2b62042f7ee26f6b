#pragma once
// Maximum intensity projection of the context, J. W. Wallis, T. R. Miller, C. A. Lerner, E. C. Kleerup:
// Three-dimensional display in nuclear medicine, IEEE Transactions on Medical Imaging 8(4), 1989, with the focus opened
// into it as the adaptive cutaway does. rendering/passes/MaximumPass.h has the formula.

#include "rendering/vocabulary/MethodStages.h"
#include "rendering/vocabulary/Setting.h"

namespace fenestra {

namespace methods {

struct Mip {
  static constexpr const char* word = "mip";
  static constexpr const char* name = "Maximum intensity (MIP)";
  static constexpr const char* description =
      "The body shows by the greatest value on each line of sight, as in a maximum intensity projection, and the focus "
      "stands in it; what lies before the opening does not count (Wallis, Miller, Lerner and Kleerup 1989)";

  double thickness = 10.0;  ///< mm, 0.01 to 1e5: of the layer that shows the greatest value's colour and opacity

  MethodStages stages() const {
    MethodStages stages;
    stages.maximum = {thickness};
    return stages;
  }
  bool operator==(const Mip&) const = default;
};

}  // namespace methods

template <>
inline constexpr std::tuple settingsOf<methods::Mip>{
    Setting(&methods::Mip::thickness,
            {.key = "mip_thickness",
             .option = "--mip-thickness",
             .name = "Thickness",
             .description = "How thick a layer the maximum intensity projection shows of the greatest value: more is "
                            "more opaque",
             .unit = "mm",
             .range = {0.01, 1e5},
             .slider = {0.5, 100.0},
             .step = 0.5})};

}  // namespace fenestra
