#include "io/base/Units.h"

#include <algorithm>
#include <array>

#include "io/base/Text.h"

namespace fenestra::io {
namespace {

struct Unit {
  std::string_view word;  ///< singular, in lower case
  double millimetres;
};

// Signs come as a micro sign or a Greek letter in UTF-8, or as one byte of Latin-1.
constexpr std::array units{Unit{"mm", 1.0},        Unit{"millimeter", 1.0},  Unit{"millimetre", 1.0},
                           Unit{"um", 1e-3},       Unit{"\xC2\xB5m", 1e-3},  Unit{"\xCE\xBCm", 1e-3},
                           Unit{"\xB5m", 1e-3},    Unit{"\\u00b5m", 1e-3},  // as ImageJ writes it
                           Unit{"micron", 1e-3},   Unit{"micrometer", 1e-3}, Unit{"micrometre", 1e-3},
                           Unit{"nm", 1e-6},       Unit{"nanometer", 1e-6},  Unit{"nanometre", 1e-6},
                           Unit{"\xC3\x85", 1e-7}, Unit{"\xC5", 1e-7},       Unit{"angstrom", 1e-7},
                           Unit{"cm", 10.0},       Unit{"centimeter", 10.0}, Unit{"centimetre", 10.0},
                           Unit{"dm", 100.0},      Unit{"m", 1000.0},        Unit{"meter", 1000.0},
                           Unit{"metre", 1000.0},  Unit{"in", 25.4},         Unit{"inch", 25.4},
                           Unit{"inche", 25.4}};  // of "inches"

}  // namespace

std::optional<double> millimetresIn(std::string_view unit) {
  const std::string word = lowered(trimmed(unit));
  const auto find = [](std::string_view wanted) {
    return std::find_if(units.begin(), units.end(), [&](const Unit& known) { return known.word == wanted; });
  };
  auto at = find(word);
  // No abbreviation ends in s, so that what is left of a plural is a whole word.
  if (at == units.end() && word.size() > 3 && word.ends_with('s'))
    at = find(std::string_view(word).substr(0, word.size() - 1));
  if (at == units.end()) return std::nullopt;
  return at->millimetres;
}

bool isNoUnit(std::string_view unit) {
  const std::string word = lowered(trimmed(unit));
  return word.empty() || word == "?" || word == "???" || word == "none" || word == "unknown";
}

std::string unknownUnit(std::string_view unit) {
  // Bytes that are no text would break the line.
  std::string shown;
  for (const char c : unit.substr(0, 32)) shown += c >= ' ' && c <= '~' ? c : '?';
  return "its unit of length \"" + shown + "\" is not known; lengths are read as millimetres";
}

}  // namespace fenestra::io
