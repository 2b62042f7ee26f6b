#pragma once
// The texts of libraries that do not know Qt, translated: the names, descriptions and units of
// rendering/settings/Settings.h, and what jobs say about their progress.

#include <string>
#include <string_view>

#include <QCoreApplication>
#include <QString>

namespace fenestra::viewer {

/// A text of a setting's declaration or of a word.
inline QString translated(const char* text) {
  return *text ? QCoreApplication::translate("Settings", text) : QString();
}
inline QString translated(std::string_view text) { return translated(std::string(text).c_str()); }

/// A unit behind a number, with the space between them; empty without a unit.
inline QString unitSuffix(const char* unit) { return *unit ? QStringLiteral(" ") + translated(unit) : QString(); }

}  // namespace fenestra::viewer
