#pragma once
// Who owns a setting of the window, and so what becomes of it when a study opens. The user guide has the same table
// (resources/guide/look.md); a test holds the two together and opens studies to see that each row is true.
//
// A study without a session starts with its own data's settings, in the chosen look and with the user's habits. A
// session brings all of them, and the next study has the habits of before.

#include <cstdint>
#include <span>

#include "io/session/LookFile.h"
#include "io/study/Study.h"

namespace fenestra::viewer {

enum class SettingOwner : std::uint8_t {
  Data,  ///< goes with the study
  Look,  ///< starts anew from the chosen preset of a whole look, or from the defaults
  Habit  ///< stays
};

struct OwnedSetting {
  const char* name;  ///< as the user guide calls it
  SettingOwner owner;
};
std::span<const OwnedSetting> ownedSettings();
const char* nameOf(SettingOwner owner);

/// Shows a study that was just read in a preset of a whole look. Where the preset was made for values of another unit,
/// the transfer function stays that of the data.
void startIn(io::Study& study, const io::LookPreset& preset);

}  // namespace fenestra::viewer
