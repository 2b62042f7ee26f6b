#include "io/deidentify/PlainWords.h"

#include <algorithm>
#include <cctype>

#include "fenestra/resources.h"
#include "io/base/Text.h"

namespace fenestra::io::deidentify {
namespace {

const Names& harmless() {
  static const Names list = [] {
    Names read;
    for (const std::string& line : split(resources::find("deidentify/words.txt"), '\n'))
      if (!line.starts_with("#"))
        for (const std::string& word : words(line)) read.insert(word);
    return read;
  }();
  return list;
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// "5", "1.25", "0.5mm", "120kV": no more than three digits, then as many behind a point, then a harmless unit. Longer
/// runs of digits may be dates and numbers of patients.
bool isShortNumber(std::string_view word) {
  constexpr std::size_t most = 3;
  const auto digits = [&] {
    std::size_t count = 0;
    while (count < word.size() && isDigit(word[count])) ++count;
    word.remove_prefix(count);
    return count;
  };
  const std::size_t whole = digits();
  if (whole == 0 || whole > most) return false;
  if (!word.empty() && (word.front() == '.' || word.front() == ',')) {
    word.remove_prefix(1);
    if (const std::size_t behind = digits(); behind == 0 || behind > most) return false;
  }
  return word.empty() || harmless().contains(word);
}

bool isPartOfWord(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || std::isalnum(byte) != 0;
}

}  // namespace

std::vector<std::string> wordsIn(std::string_view text) {
  std::vector<std::string> found;
  bool inside = false;
  for (const char c : text) {
    const bool part = isPartOfWord(c);
    if (part && !inside) found.emplace_back();
    if (part) found.back() += c;
    inside = part;
  }
  for (std::string& word : found) word = lowered(word);
  return found;
}

std::string plainWords(std::string_view text, const Names& names) {
  std::string kept;
  std::size_t at = 0;
  std::size_t digitsInARow = 0;  // numbers that follow each other may be parts of a date
  while (at < text.size()) {
    if (!isPartOfWord(text[at])) {
      ++at;
      continue;
    }
    const std::size_t begin = at;
    const auto isPoint = [&](std::size_t i) {
      return (text[i] == '.' || text[i] == ',') && i > begin && isDigit(text[i - 1]) && i + 1 < text.size() &&
             isDigit(text[i + 1]);
    };
    while (at < text.size() && (isPartOfWord(text[at]) || isPoint(at))) ++at;
    const std::string word = lowered(std::string(text.substr(begin, at - begin)));
    const bool isNumber = isShortNumber(word);
    digitsInARow = isDigit(word.front()) && isDigit(word.back()) ? digitsInARow + 1 : 0;
    if (names.contains(word) || digitsInARow > 1 || !(isNumber || harmless().contains(word))) continue;
    if (!kept.empty()) kept += ' ';
    kept += text.substr(begin, at - begin);
  }
  return kept;
}

}  // namespace fenestra::io::deidentify
