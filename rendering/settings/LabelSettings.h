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
  double opacity = 1.0;                 ///< 0..1: see opticalExtinction; also of its tint on slices
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

/// Extinction (1/mm) of a structure at an opacity: 10 mm of it have that share of the opacity that they have at 1. So
/// half of the slider is half of what is seen, whatever the extinction.
///
/// It applies to a label's material or function in focus (see focusFunction), and in the context to the volume's
/// transfer function where the nearest voxel has the label (see FaintLabels). At 0 a label of the context is hidden.
double opticalExtinction(double extinction, double opacity);

/// A function with the extinction of each node at that opacity; linear between the nodes.
TransferFunction atOpacity(TransferFunction function, double opacity);

}  // namespace fenestra
