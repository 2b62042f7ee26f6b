#include "io/base/SeriesChoice.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string_view>

#include "io/base/NaturalOrder.h"
#include "io/base/Text.h"

namespace fenestra::io {
namespace {

bool hasWord(const std::vector<std::string>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::vector<std::string> imageTypeOf(const SeriesInfo& series) {
  std::vector<std::string> words;
  for (const std::string& word : split(series.imageType, '\\')) words.push_back(trimmed(word));
  return words;
}

/// No localiser, no secondary capture, no picture made from other series.
bool isAcquired(const SeriesInfo& series) {
  // Secondary Capture Image Storage and its multi-frame forms, PS3.4 B.5.
  constexpr std::string_view capture = "1.2.840.10008.5.1.4.1.1.7";
  if (series.sopClass == capture || series.sopClass.starts_with(std::string(capture) + '.')) return false;
  // LOCALIZER and PROJECTION IMAGE are the standard's values, CURVED_MPR, MAX_IP and the like its words for techniques;
  // scanners and workstations write the others.
  static constexpr std::array<std::string_view, 18> made = {
      "LOCALIZER", "SCOUT",         "REFORMATTED", "MPR",         "CURVED_MPR", "CSA MPR",
      "CPR",       "MIP",           "MAX_IP",      "MINIP",       "MIN_IP",     "PROJECTION IMAGE",
      "CSA MIP",   "VOLUME_RENDER", "VRT",         "SCREEN SAVE", "SCREENSHOT", "DOSE REPORT"};
  const std::vector<std::string> words = imageTypeOf(series);
  if (hasWord(words, "DERIVED") && hasWord(words, "SECONDARY")) return false;
  return std::none_of(made.begin(), made.end(), [&](std::string_view word) { return hasWord(words, word); });
}

bool isOriginal(const SeriesInfo& series) {
  const std::vector<std::string> words = imageTypeOf(series);
  return words.size() > 1 && words[0] == "ORIGINAL" && words[1] == "PRIMARY";
}

double voxelsOf(const SeriesInfo& series) { return static_cast<double>(series.dims.x) * series.dims.y * series.dims.z; }

/// The lines of the rule before its last one, the id.
namespace line {
enum : std::size_t { plausible, acquired, volume, original, thinnest, mostVoxels, lowestNumber, count };
}
using Ranks = std::array<double, line::count>;

/// How each line of the rule ranks a series, lowest first.
Ranks ranksOf(const SeriesInfo& series) {
  constexpr double micrometre = 1e-3;  // mm: positions in headers are no more exact
  const bool isVolume = series.dims.z >= leastSlices;
  const bool hasStep = isVolume && series.step > 0.0 && std::isfinite(series.step);
  return {series.plausible ? 0.0 : 1.0,
          isAcquired(series) ? 0.0 : 1.0,
          isVolume ? 0.0 : (series.dims.z > 1 ? 1.0 : 2.0),
          isOriginal(series) ? 0.0 : 1.0,
          hasStep ? std::round(series.step / micrometre) : std::numeric_limits<double>::infinity(),
          -voxelsOf(series),
          series.number ? static_cast<double>(*series.number) : std::numeric_limits<double>::infinity()};
}

struct Ranked {
  Ranks ranks;
  const SeriesInfo* series;
};

bool isBefore(const Ranked& a, const Ranked& b) {
  return a.ranks != b.ranks ? a.ranks < b.ranks : isBeforeNaturally(a.series->id, b.series->id);
}

std::string millimetres(double length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", length);
  std::string digits = text;
  while (digits.ends_with('0') && !digits.ends_with(".0")) digits.pop_back();
  return digits + " mm";
}

/// What a sentence calls `first`, with all that it says of itself against those that an earlier line put behind it.
std::string nounOf(const Ranked& first) {
  const double kind = first.ranks[line::volume];
  const std::string noun = kind == 0.0 ? "volume" : kind == 1.0 ? "stack of slices" : "image";
  if (first.ranks[line::acquired] != 0.0) return noun;
  return first.ranks[line::original] == 0.0 ? "acquired " + noun : noun + " that is no overview, capture or reformat";
}

/// Why `first` comes before the others, of which the next one differs from it in line `decided` first.
Phrase reasonOf(const Ranked& first, std::size_t decided) {
  const std::string noun = nounOf(first);
  switch (decided) {
    case line::plausible:
      return {"the only one whose geometry is plausible", {}};
    case line::acquired:
      return {"the only one that is no overview, capture or reformat", {}};
    case line::volume:
    case line::original:
      return {"the only %1", {noun}};
    case line::thinnest:
      return {"the thinnest %1, %2", {noun, millimetres(first.series->step)}};
    case line::mostVoxels:
      if (std::isfinite(first.ranks[line::thinnest]))
        return {"of the thinnest ones, %1, the one of most voxels", {millimetres(first.series->step)}};
      return {"the %1 of most voxels", {noun}};
    case line::lowestNumber:
      return {"of equal ones the first by its number, %1", {std::to_string(*first.series->number)}};
    default:
      return {};
  }
}

}  // namespace

SeriesChoice firstSeries(const std::vector<SeriesInfo>& series) {
  assert(!series.empty());
  std::vector<Ranked> ranked;
  for (const SeriesInfo& each : series) ranked.push_back({ranksOf(each), &each});
  const std::size_t ahead = std::min<std::size_t>(ranked.size(), 2);
  std::partial_sort(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(ahead), ranked.end(), isBefore);
  SeriesChoice choice;
  choice.index = static_cast<std::size_t>(ranked[0].series - series.data());
  if (ahead < 2) return choice;
  const auto& first = ranked[0].ranks;
  const auto differ = std::mismatch(first.begin(), first.end(), ranked[1].ranks.begin()).first;
  choice.reason = reasonOf(ranked[0], static_cast<std::size_t>(differ - first.begin()));
  return choice;
}

}  // namespace fenestra::io
