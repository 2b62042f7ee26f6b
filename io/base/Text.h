#pragma once
// Words and numbers in text, whatever the locale: of file headers and of command lines.

#include <charconv>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace fenestra::io {

/// What a field of text holds: up to its first NUL, without blanks around it. Writers pad fields with either.
inline std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  text = text.substr(0, text.find('\0'));
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

inline std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

/// The parts between separators, empty ones included.
inline std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.emplace_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

/// The whole of `word` as a number; empty when it is none.
template <class T>
std::optional<T> numberIn(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  T value{};
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (failure != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// As numberIn, for a list of words; empty unless every word is a number.
template <class T>
std::optional<std::vector<T>> numbersIn(const std::string& text) {
  std::vector<T> result;
  for (const std::string& word : words(text)) {
    const auto value = numberIn<T>(word);
    if (!value) return std::nullopt;
    result.push_back(*value);
  }
  return result;
}

/// A number as people write it, whatever the locale.
inline std::string plainNumber(double number) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << number;
  return text.str();
}

/// A number that is written with a decimal comma, as some programs do in some countries; empty for any other word.
inline std::optional<double> commaNumberIn(std::string word) {
  const std::size_t comma = word.find(',');
  if (comma == std::string::npos || word.find('.') != std::string::npos) return std::nullopt;
  word[comma] = '.';
  return numberIn<double>(word);
}

/// ASCII letters in lower case; other characters stay.
inline std::string lowered(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace fenestra::io
