#include "io/archive/Wildcards.h"

#include "io/base/Text.h"

namespace fenestra::io::archive {
namespace {

std::size_t nextCharacter(std::string_view text, std::size_t at) {
  ++at;
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80) ++at;
  return at;
}

bool matchesWhole(std::string_view pattern, std::string_view text) {
  constexpr std::size_t none = std::string_view::npos;
  std::size_t p = 0, t = 0, star = none, resumed = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resumed = t;
    } else if (p < pattern.size() && pattern[p] == '?') {
      ++p;
      t = nextCharacter(text, t);
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p;
      ++t;
    } else if (star != none) {  // the last star takes one character more
      p = star + 1;
      t = resumed = nextCharacter(text, resumed);
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

}  // namespace

bool matches(std::string_view pattern, std::string_view text) {
  const std::string wanted = lowered(std::string(pattern)), there = lowered(std::string(text));
  if (matchesWhole(wanted, there)) return true;
  for (const std::string& group : split(there, '='))
    if (matchesWhole(wanted, group)) return true;
  return false;
}

}  // namespace fenestra::io::archive
