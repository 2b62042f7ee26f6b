#pragma once
// Words of lengths in file headers, for every format that names its unit.

#include <optional>
#include <string>
#include <string_view>

namespace fenestra::io {

/// Millimetres in the unit that a header names: a metre and its parts down to ångström, or an inch; singular or plural,
/// British or American, the signs µ and Å in UTF-8 or Latin-1. Case counts for nothing. Empty where the word is
/// unknown.
std::optional<double> millimetresIn(std::string_view unit);
/// Whether a header says that it names no unit: an empty word, "?", "???", "none" or "unknown".
bool isNoUnit(std::string_view unit);
/// The sentence that says that lengths in an unknown unit are read as millimetres.
std::string unknownUnit(std::string_view unit);

}  // namespace fenestra::io
