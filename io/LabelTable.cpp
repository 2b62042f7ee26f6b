#include "io/LabelTable.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "io/base/ByteStream.h"
#include "io/base/LabelReading.h"
#include "io/base/Text.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// FreeSurfer's table has 100 kilobytes.
constexpr std::size_t longestTable = 16u << 20;

void addUtf8(std::uint32_t point, std::string& text) {
  if (point < 0x80) {
    text += static_cast<char>(point);
    return;
  }
  constexpr std::array<std::uint32_t, 4> lead{0, 0xc0, 0xe0, 0xf0};
  const std::size_t following = point < 0x800 ? 1 : point < 0x10000 ? 2 : 3;
  text += static_cast<char>(lead[following] | point >> 6 * following);
  for (std::size_t i = following; i-- > 0;) text += static_cast<char>(0x80 | (point >> 6 * i & 0x3f));
}

/// UTF-16 behind its byte order mark, as spreadsheets write text; surrogates (RFC 2781) are joined.
std::string fromUtf16(const std::string& bytes) {
  const bool big = bytes[0] == '\xfe';
  const auto unit = [&](std::size_t at) -> std::uint32_t {
    const auto first = static_cast<unsigned char>(bytes[at]), second = static_cast<unsigned char>(bytes[at + 1]);
    return big ? first << 8 | second : second << 8 | first;
  };
  std::string text;
  for (std::size_t at = 2; at + 1 < bytes.size(); at += 2) {
    std::uint32_t point = unit(at);
    if ((point & 0xfc00) == 0xd800 && at + 3 < bytes.size() && (unit(at + 2) & 0xfc00) == 0xdc00) {
      point = 0x10000 + ((point & 0x3ff) << 10 | (unit(at + 2) & 0x3ff));
      at += 2;
    }
    addUtf8(point, text);
  }
  return text;
}

std::vector<std::string> linesOf(const fs::path& file) {
  const auto stream = openStream(file, 0, Packing::None);
  std::error_code unknown;
  const std::uintmax_t size = fs::file_size(file, unknown);
  std::string text(unknown ? longestTable : std::min<std::uintmax_t>(size, longestTable), '\0');
  text.resize(stream->read(reinterpret_cast<std::byte*>(text.data()), text.size()));
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) text = fromUtf16(text);
  return split(text, '\n');
}

std::optional<glm::dvec3> colourOf(const std::vector<std::string>& words, std::size_t first) {
  glm::dvec3 colour(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = first + i < words.size() ? numberIn<int>(trimmed(words[first + i])) : std::nullopt;
    if (!value || *value < 0 || *value > 255) return std::nullopt;
    colour[static_cast<int>(i)] = *value / 255.0;
  }
  return colour;
}

/// "#RRGGBB"
std::optional<glm::dvec3> hexColour(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  unsigned rgb = 0;
  const auto [end, failure] = std::from_chars(text.data() + 1, text.data() + 7, rgb, 16);
  if (failure != std::errc() || end != text.data() + 7) return std::nullopt;
  return glm::dvec3((rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255) / 255.0;
}

std::optional<std::uint16_t> valueIn(const std::string& word) {
  const auto value = numberIn<std::uint16_t>(trimmed(word));
  return value && *value > 0 ? value : std::nullopt;
}

/// The cells of a line. Quotes may stand around a cell (RFC 4180): separators in them are its own, and two quotes are
/// one.
std::vector<std::string> cellsOf(const std::string& line, char separator) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if (quoted && c == '"' && at + 1 < line.size() && line[at + 1] == '"')
      cells.back() += line[++at];
    else if (c == '"' && (quoted || trimmed(cells.back()).empty()))
      quoted = !quoted;
    else if (c == separator && !quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

/// Columns that a table's first line names, by their index.
struct Columns {
  char separator = '\t';
  std::size_t value, name;
  std::optional<std::size_t> hex, red;  ///< red: green and blue follow

  static std::optional<Columns> in(const std::string& line) {
    for (const char separator : {'\t', ',', ';'}) {
      std::vector<std::string> names;
      for (const std::string& name : cellsOf(line, separator)) names.push_back(lowered(trimmed(name)));
      const auto find = [&](std::initializer_list<const char*> wanted) -> std::optional<std::size_t> {
        for (const char* word : wanted)
          if (const auto at = std::find(names.begin(), names.end(), word); at != names.end())
            return static_cast<std::size_t>(at - names.begin());
        return std::nullopt;
      };
      const auto value = find({"index", "value", "labelvalue", "label_value", "id"}), name = find({"name"});
      if (value && name) return Columns{separator, *value, *name, find({"color", "colour"}), find({"color_r"})};
    }
    return std::nullopt;
  }

  std::optional<Label> row(const std::string& line) const {
    const std::vector<std::string> cells = cellsOf(line, separator);
    if (std::max(value, name) >= cells.size()) return std::nullopt;
    const auto number = valueIn(cells[value]);
    if (!number) return std::nullopt;
    std::optional<glm::dvec3> colour;
    if (hex && *hex < cells.size()) colour = hexColour(trimmed(cells[*hex]));
    if (red) colour = colourOf(cells, *red);
    return Label{*number, trimmed(cells[name]), colour.value_or(noColour)};
  }
};

/// A line that begins with a label's number.
std::optional<Label> plainRow(const std::string& line) {
  const std::size_t end = line.find_first_of(" \t");
  const auto value = valueIn(line.substr(0, end));
  if (!value || end == std::string::npos) return std::nullopt;
  const std::string rest = trimmed(line.substr(end));
  if (const std::size_t quote = rest.find('"'); quote != std::string::npos) {
    const std::string name = rest.substr(quote + 1, rest.find('"', quote + 1) - quote - 1);
    return Label{*value, trimmed(name), colourOf(words(rest.substr(0, quote)), 0).value_or(noColour)};
  }
  if (line[end] == '\t') {
    const std::size_t tab = rest.find('\t');
    const std::string behind = tab == std::string::npos ? std::string() : rest.substr(tab);
    return Label{*value, trimmed(rest.substr(0, tab)), colourOf(words(behind), 0).value_or(noColour)};
  }
  const std::vector<std::string> parts = words(rest);
  std::size_t numbers = 0;
  while (numbers < 4 && numbers + 1 < parts.size() && numberIn<int>(parts[parts.size() - 1 - numbers])) ++numbers;
  const std::size_t first = parts.size() - numbers;
  const auto colour = numbers >= 3 ? colourOf(parts, first) : std::nullopt;
  if (!colour) return Label{*value, parts.empty() ? std::string() : parts.front(), noColour};
  // A name may hold blanks: it ends where the colour begins.
  std::string name = parts.front();
  for (std::size_t i = 1; i < first; ++i) name += " " + parts[i];
  return Label{*value, name, *colour};
}

}  // namespace

std::vector<Label> readLabelTable(const fs::path& file) {
  std::vector<Label> labels;
  std::optional<Columns> columns;
  for (const std::string& text : linesOf(file)) {
    if (labels.empty() && !columns) columns = Columns::in(text);
    std::optional<Label> label = columns ? columns->row(text) : plainRow(trimmed(text));
    if (label && !label->name.empty()) labels.push_back(std::move(*label));
  }
  return labels;
}

fs::path tableBeside(const fs::path& labels) {
  std::vector<fs::path> candidates;
  for (fs::path stem = labels; stem.has_extension();) {
    stem.replace_extension();
    for (const char* ending : {".txt", ".tsv", ".csv", ".label", ".ctbl", ".lut"})
      candidates.push_back(fs::path(stem) += ending);
  }
  const fs::path folder = labels.parent_path();
  for (const char* name : {"labels.tsv", "labels.txt", "FreeSurferColorLUT.txt"}) candidates.push_back(folder / name);
  const std::string name = labels.filename().string(), stem = name.substr(0, name.find('.'));
  if (stem.ends_with("_dseg")) {
    // A file of BIDS inherits the tables of the folders above, whose names have a part of its entities.
    fs::path above = folder;
    for (int level = 0; level < 4; ++level, above = above / "..")
      for (std::size_t at = stem.find('_'); at != std::string::npos; at = stem.find('_', at + 1))
        candidates.push_back(above / (stem.substr(at + 1) + ".tsv"));
  }
  std::error_code unknown;
  for (const fs::path& candidate : candidates)
    if (candidate != labels && fs::is_regular_file(candidate, unknown)) return candidate;
  return {};
}

}  // namespace fenestra::io
