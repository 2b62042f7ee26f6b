#pragma once
// Text in SVG and HTML.

#include <string>

namespace fenestra::bench {

/// `text` with the characters that would begin a mark written as entities.
inline std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : std::string(1, c);
  return result;
}

}  // namespace fenestra::bench
