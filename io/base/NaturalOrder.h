#pragma once
// The order of names as people number them: "slice2" before "slice10".

#include <algorithm>
#include <string_view>

namespace fenestra::io {

/// Whether `a` comes before `b`: runs of digits compare as numbers, all else by its bytes.
inline bool isBeforeNaturally(std::string_view a, std::string_view b) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  const auto runAt = [&](std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && isDigit(text[end])) ++end;
    return text.substr(at, end - at);
  };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      const std::string_view left = runAt(a, i), right = runAt(b, j);
      const auto significant = [](std::string_view digits) {
        return digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
      };
      const std::string_view x = significant(left), y = significant(right);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
      i += left.size();
      j += right.size();
    } else {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i;
      ++j;
    }
  }
  // Names that differ in leading zeros alone keep a fixed order.
  if (i == a.size() && j == b.size()) return a < b;
  return i == a.size();
}

}  // namespace fenestra::io
