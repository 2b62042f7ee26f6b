#include "io/formats/NrrdHeader.h"

#include <algorithm>

#include "io/base/ByteStream.h"
#include "io/base/Text.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// Headers are a few kilobytes; Slicer's segmentations write one line of terminology a segment.
constexpr std::size_t longestHeader = 16u << 20;

/// Field names come with and without blanks ("data file", "datafile").
std::string withoutBlanks(const std::string& text) {
  std::string result;
  for (const char c : lowered(text))
    if (c != ' ') result += c;
  return result;
}

/// The value of a pair without NRRD's escapes.
std::string unescaped(const std::string& value) {
  std::string result;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const bool escape = value[i] == '\\' && i + 1 < value.size() && (value[i + 1] == '\\' || value[i + 1] == 'n');
    result += !escape ? value[i] : value[i + 1] == 'n' ? '\n' : '\\';
    i += escape;
  }
  return result;
}

}  // namespace

NrrdHeader readNrrdLines(const fs::path& path) {
  const auto stream = openStream(path, 0, Packing::None);
  NrrdHeader header;
  std::vector<char> buffer(16 * 1024);
  std::string line;
  bool first = true, listing = false;
  std::size_t got = 0, at = 0;
  for (;;) {
    if (at == got) {
      got = stream->read(reinterpret_cast<std::byte*>(buffer.data()), buffer.size());
      at = 0;
    }
    const bool ended = got == 0;
    if (!ended) {
      ++header.bytes;
      if (header.bytes > longestHeader) throw Error(path, "its header has no end", "the file is damaged");
      const char c = buffer[at++];
      if (c != '\n') {
        line += c;
        continue;
      }
    }
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) return header;
    if (listing) {
      header.listed.push_back(trimmed(line));
    } else if (!first && line.front() != '#') {
      const std::size_t colon = line.find(": "), pair = line.find(":=");
      if (pair != std::string::npos && (colon == std::string::npos || pair < colon)) {
        header.pairs[line.substr(0, pair)] = unescaped(trimmed(line.substr(pair + 2)));
      } else if (colon != std::string::npos || line.back() == ':') {
        const std::size_t end = colon == std::string::npos ? line.size() - 1 : colon;
        const std::string name = withoutBlanks(line.substr(0, end));
        const std::string value = trimmed(line.substr(end + 1));
        listing = name == "datafile" && words(value).size() >= 1 && words(value)[0] == "LIST";
        header.fields[name] = value;
      } else {
        throw Error(path, "its header has a line that is no field", "the file is damaged or no NRRD file");
      }
    }
    first = false;
    line.clear();
    if (ended) return header;
  }
}

std::optional<std::vector<std::optional<SpaceVector>>> vectorsIn(const std::string& text) {
  std::vector<std::optional<SpaceVector>> result;
  std::size_t dimension = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == ' ' || text[at] == '\t') {
      ++at;
    } else if (text.compare(at, 4, "none") == 0) {
      result.emplace_back();
      at += 4;
    } else if (text[at] == '(') {
      const std::size_t end = text.find(')', at);
      if (end == std::string::npos) return std::nullopt;
      std::string inside = text.substr(at + 1, end - at - 1);
      for (char& c : inside)
        if (c == ',') c = ' ';
      const auto numbers = numbersIn<double>(inside);
      if (!numbers || numbers->size() < 2 || numbers->size() > 4) return std::nullopt;
      if (dimension != 0 && numbers->size() != dimension) return std::nullopt;
      dimension = numbers->size();
      SpaceVector vector{.dimension = dimension};
      for (std::size_t i = 0; i < std::min<std::size_t>(dimension, 3); ++i)
        vector.place[static_cast<int>(i)] = (*numbers)[i];
      if (dimension == 4) vector.time = (*numbers)[3];
      result.emplace_back(vector);
      at = end + 1;
    } else {
      return std::nullopt;
    }
  }
  return result;
}

std::vector<std::string> quotedWords(const std::string& text) {
  if (text.find('"') == std::string::npos) return words(text);
  std::vector<std::string> result;
  const std::vector<std::string> parts = split(text, '"');
  for (std::size_t i = 1; i < parts.size(); i += 2) result.push_back(parts[i]);
  return result;
}

}  // namespace fenestra::io
