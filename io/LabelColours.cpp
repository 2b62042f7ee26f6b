#include "io/LabelColours.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>
#include <vector>

#include "fenestra/resources.h"
#include "io/base/Text.h"
#include "rendering/volume/LabelMap.h"

namespace fenestra::io {
namespace {

using Words = std::vector<std::string>;

/// A plural's singular, as far as names of structures need it; the table's words went the same way.
std::string singular(std::string word) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> endings{
      {{"brae", "bra"}, {"ries", "ry"}, {"ches", "ch"}}};
  for (const auto& [plural, single] : endings)
    if (word.ends_with(plural)) return word.substr(0, word.size() - plural.size()).append(single);
  if (word.size() > 3 && word.ends_with("s") && !word.ends_with("ss")) word.pop_back();
  return word;
}

/// Lower case, parted at anything but letters and digits and where a small letter meets a capital one.
Words wordsIn(std::string_view name) {
  Words words;
  bool wasSmall = false, open = false;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte)) {
      const bool capital = std::isupper(byte) != 0;
      if (!open || (capital && wasSmall)) words.emplace_back();
      words.back().push_back(static_cast<char>(std::tolower(byte)));
      wasSmall = std::islower(byte) != 0;
      open = true;
    } else {
      open = wasSmall = false;
    }
  }
  std::transform(words.begin(), words.end(), words.begin(), singular);
  return words;
}

bool isSide(const std::string& word) {
  constexpr std::array<std::string_view, 7> sides{"left", "right", "l", "r", "lh", "rh", "ctx"};
  return std::find(sides.begin(), sides.end(), word) != sides.end();
}

struct Entry {
  Words words;
  std::size_t letters = 0;
  glm::dvec3 colour{0.0};
};

std::vector<Entry> readTable() {
  std::vector<Entry> entries;
  for (const std::string& line : split(resources::find("labels/colours.tsv"), '\n')) {
    const std::size_t tab = line.find('\t');
    if (line.starts_with('#') || tab == std::string::npos) continue;
    Entry entry{wordsIn(line.substr(0, tab)), tab, {}};
    const unsigned long rgb = std::stoul(line.substr(tab + 2), nullptr, 16);
    entry.colour = glm::dvec3((rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255) / 255.0;
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace

glm::dvec3 labelColour(std::uint16_t value, std::string_view name) {
  static const std::vector<Entry> table = readTable();
  Words words = wordsIn(name);
  std::erase_if(words, isSide);
  const auto fits = [&](const Entry& entry) {
    return std::all_of(entry.words.begin(), entry.words.end(), [&](const std::string& word) {
      return std::find(words.begin(), words.end(), word) != words.end();
    });
  };
  const Entry* best = nullptr;
  for (const Entry& entry : table)
    if (fits(entry) &&
        (!best || std::pair(entry.words.size(), entry.letters) > std::pair(best->words.size(), best->letters)))
      best = &entry;
  if (!best) return defaultLabelColour(value);

  // What the entry leaves over of the name tells the parts of a structure apart: neighbours in a numbered row have
  // neighbouring brightness, but never the same.
  unsigned rest = 0;
  for (const std::string& word : words)
    if (std::find(best->words.begin(), best->words.end(), word) == best->words.end())
      for (const char c : word) rest += static_cast<unsigned char>(c);
  constexpr unsigned shades = 4;
  return best->colour * (1.0 - 0.09 * (rest % shades));
}

}  // namespace fenestra::io
