#pragma once
// The texts of libraries that do not know Qt, translated: the names, descriptions and units of
// rendering/settings/Settings.h, what jobs say about their progress, and phrases of readers.

#include <string>
#include <string_view>

#include <QCoreApplication>
#include <QString>

#include "io/base/Phrase.h"

namespace fenestra::viewer {

/// A text of a setting's declaration or of a word.
inline QString translated(const char* text) {
  return *text ? QCoreApplication::translate("Settings", text) : QString();
}
inline QString translated(std::string_view text) { return translated(std::string(text).c_str()); }

/// A phrase with its words.
inline QString translated(const io::Phrase& phrase) {
  QString text = translated(phrase.text.c_str());
  for (const std::string& value : phrase.values) text = text.arg(translated(value.c_str()));
  return text;
}

/// A unit behind a number, with the space between them; empty without a unit.
inline QString unitSuffix(const char* unit) { return *unit ? QStringLiteral(" ") + translated(unit) : QString(); }

}  // namespace fenestra::viewer
