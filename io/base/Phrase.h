#pragma once
// A text with values in it, which a program can translate before the values are put in.

#include <string>
#include <utility>
#include <vector>

namespace fenestra::io {

struct Phrase {
  std::string text;                 ///< "the thinnest %1, %2"
  std::vector<std::string> values;  ///< of %1, %2, …; words among them can be translated, too

  bool empty() const { return text.empty(); }
  bool operator==(const Phrase&) const = default;
};

/// With the values in their places.
inline std::string plainText(const Phrase& phrase) {
  std::string text = phrase.text;
  for (std::size_t i = 0; i < phrase.values.size(); ++i)
    if (const std::size_t at = text.find('%' + std::to_string(i + 1)); at != std::string::npos)
      text.replace(at, 2, phrase.values[i]);
  return text;
}

}  // namespace fenestra::io
