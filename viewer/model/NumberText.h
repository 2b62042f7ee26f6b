#pragma once
// Numbers and units as people write them.

#include <string>

#include <QString>

namespace fenestra::viewer {

/// With so many digits behind the point, which is that of the language; `format` as for QString::number().
QString numberText(double value, int decimals, char format = 'f');
/// "0.012 ml", "12.3 ml", "1 533 ml", "14.1 l".
QString volumeText(double ml);
/// A unit for fields and corners: "HU" for the spellings of Hounsfield units; one that would overflow ends in dots.
QString unitText(const std::string& unit);
/// unitText() behind a number, with the space between them; empty without a unit.
QString unitSuffix(const std::string& unit);

}  // namespace fenestra::viewer
