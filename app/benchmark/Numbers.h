#pragma once
// Numbers as a report writes them.

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

namespace fenestra::bench {

inline std::string fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

/// Three significant digits, without an exponent where that is readable.
inline std::string number(double value) {
  if (!std::isfinite(value)) return "∞";
  const double size = std::abs(value);
  if (size == 0.0) return "0";
  if (size < 1e-4) {
    std::ostringstream text;
    text << std::setprecision(2) << value;
    return text.str();
  }
  std::string text = fixed(value, std::max(0, 2 - static_cast<int>(std::floor(std::log10(size)))));
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace fenestra::bench
