#pragma once
// How single labels are shown, beside being in focus or not, which Look::focus alone says.

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "rendering/settings/TransferFunction.h"

namespace fenestra {

/// What becomes of a label that is not in focus.
enum class LabelRole : std::uint8_t {
  Context,    ///< shown, and cut away around the focus
  Hidden,     ///< its voxels are air in 3-D pictures; slices show them
  Protected,  ///< shown, and never cut away
};

/// Levels of importance of labels run from 0, like all else, to this one; rendering/scene/Importance.h says what they
/// do.
inline constexpr int mostImportant = 4;

struct LabelSetting {
  std::uint16_t label = 0;
  LabelRole role = LabelRole::Context;  ///< while the label is not in focus
  bool visible = true;                  ///< off: slices do not tint it, 3-D pictures do not draw it in focus or keep it
  double opacity = 1.0;                 ///< 0..1: of its surface, see below; also of its tint on slices
  std::optional<glm::dvec3> colour{};   ///< display RGB 0..1, in place of the label map's
  /// Colour and extinction by value while the label is in focus, in place of one material. See focusFunction.
  std::optional<TransferFunction> function{};
  std::optional<int> importance{};  ///< 0 to mostImportant; empty: mostImportant in focus, else 0

  bool operator==(const LabelSetting&) const = default;
};

/// Ascending by label, each once; labels that are shown as they come have none.
using LabelSettings = std::vector<LabelSetting>;

/// The setting of a label, or the default.
LabelSetting settingFor(const LabelSettings& settings, std::uint16_t label);
/// Puts a setting in place; a default one removes what was there.
void put(LabelSettings& settings, const LabelSetting& setting);

// A label's opacity s is that of its surface. What a ray meets of a label in one go is a body of it: the ray is
// integrated through the body as if it were whole, and s of what that gives shows. With A the opacity that the body
// would have so far, and T the ray's transmittance,
//
//   dT = -s T0 dA,   T = T0 (1 - s A),   T0 in front of the body,
//
// and colours add up as T falls. So a body that is opaque at 1 has the opacity s, however thick it is, and the light of
// its surface; one that is not has s times the opacity that it has at 1. Behind the body's last point A falls evenly to
// 0 within the finest side of a voxel: a ray that leaves a label for less than that is still in the same body to that
// degree, so that steps and crevices of its surface as small as voxels are no surfaces of their own. A ray remembers
// the two bodies met last.
//
// It applies to labels in focus (see drawnInFocus), and in the context where the nearest voxel has the label (see
// FaintLabels). At 0 a label of the context is hidden.

/// Extinction (1/mm) of an even medium in place of a structure at an opacity: 10 mm of it have that share of the
/// opacity that they have at 1. For what has no surfaces: light through coarse cells, and what a click means.
double opticalExtinction(double extinction, double opacity);

/// A function with the extinction of each node at that opacity, as opticalExtinction(); linear between the nodes.
TransferFunction atOpacity(TransferFunction function, double opacity);

}  // namespace fenestra
