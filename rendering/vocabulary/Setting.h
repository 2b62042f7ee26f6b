#pragma once
// What a declaration of a setting is. rendering/settings/Settings.h has those of a look, each folder of
// rendering/methods those of its method.

#include <concepts>
#include <limits>
#include <tuple>

#include "rendering/vocabulary/Word.h"

namespace fenestra {

/// A closed interval of finite numbers.
struct Range {
  double low = std::numeric_limits<double>::lowest(), high = std::numeric_limits<double>::max();
  constexpr bool contains(double number) const { return number >= low && number <= high; }
};
inline constexpr Range fraction{0.0, 1.0};
/// Coordinates and lengths in mm. The limit of 1000 km is far beyond any patient, and its square fits a float.
inline constexpr Range millimetres{-1e9, 1e9}, positiveMillimetres{1e-9, 1e9}, millimetresFromZero{0.0, 1e9};
/// Greatest error of a colour that sampling may leave, in 1/255; below the least, rounding of the voxels' float32 sums
/// dominates.
inline constexpr Range maxErrors{0.05, 255.0};

/// What a setting is called, means and may be.
struct Declaration {
  const char* key;               ///< in files
  const char* option = nullptr;  ///< on the command line; null: it has none
  const char* name;              ///< label in the window
  const char* description;       ///< a phrase for tool tips, --help and the schema
  const char* unit = "";
  Range range = {};      ///< of a number
  Range slider = range;  ///< the part of `range` that a slider spans
  double step = 0.0;     ///< of a slider
};

/// One member of `Owner`: a number, a switch (bool), a choice (an enumeration with wordsOf) or a colour (display RGB).
template <class Owner, class Value>
struct Setting : Declaration {
  constexpr Setting(Value Owner::*which, const Declaration& declaration) : Declaration(declaration), member(which) {}

  Value Owner::*member;
};

/// All settings of `Owner`, in the order in which files and panels show them; empty for other structs.
template <class Owner>
inline constexpr std::tuple settingsOf{};

/// Calls use(setting) for every setting of `Owner`.
template <class Owner>
constexpr void forEachSetting(auto&& use) {
  std::apply([&](const auto&... setting) { (use(setting), ...); }, settingsOf<Owner>);
}

/// The declaration of a member, as in settingOf(&Cutaway::openWidth).
template <class Owner, class Value>
constexpr const Setting<Owner, Value>& settingOf(Value Owner::*member) {
  const Setting<Owner, Value>* found = nullptr;
  forEachSetting<Owner>([&](const auto& setting) {
    if constexpr (std::same_as<decltype(setting), const Setting<Owner, Value>&>)
      if (setting.member == member) found = &setting;
  });
  return *found;
}

}  // namespace fenestra
