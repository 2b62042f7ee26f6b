// The label table that TotalSegmentator and Connectome Workbench keep in an extension of a NIfTI header: Caret's XML,
//   <LabelTable><Label Key="5" Red="1" Green="0.5" Blue="0" Alpha="1"><![CDATA[liver]]></Label>...
// Extensions: nifti1.h, "struct nifti1_extender" and "struct nifti1_extension".

#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "io/base/Text.h"
#include "io/formats/ImageFile.h"
#include "io/formats/NiftiParts.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// A table of a thousand labels takes a hundred kilobytes.
constexpr std::int32_t longestExtension = 16 << 20;

/// The value of an attribute in `tag`, the text between "<Label" and ">".
std::optional<std::string> attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    const std::size_t quote = at + name.size() + 1;
    if (at == 0 || tag[at - 1] > ' ' || quote >= tag.size() || tag[quote - 1] != '=') continue;
    const std::size_t end = tag.find(tag[quote], quote + 1);
    if ((tag[quote] != '"' && tag[quote] != '\'') || end == std::string_view::npos) return std::nullopt;
    return std::string(tag.substr(quote + 1, end - quote - 1));
  }
  return std::nullopt;
}

/// The characters of an element's content, without CDATA's brackets and XML's escapes.
std::string plainContent(std::string_view content) {
  std::string text(content);
  const auto replaceAll = [&](std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  };
  if (text.find("<![CDATA[") != std::string::npos) {
    replaceAll("<![CDATA[", "");
    replaceAll("]]>", "");
    return trimmed(text);
  }
  replaceAll("&lt;", "<");
  replaceAll("&gt;", ">");
  replaceAll("&quot;", "\"");
  replaceAll("&apos;", "'");
  replaceAll("&amp;", "&");
  return trimmed(text);
}

/// Red, green and blue from 0 to 1.
std::optional<glm::dvec3> colourOf(std::string_view tag) {
  glm::dvec3 colour(0.0);
  int channel = 0;
  for (const char* name : {"Red", "Green", "Blue"}) {
    const auto text = attribute(tag, name);
    const auto value = text ? numberIn<double>(*text) : std::nullopt;
    if (!value || !(*value >= 0.0 && *value <= 1.0)) return std::nullopt;
    colour[channel++] = *value;
  }
  return colour;
}

std::vector<Label> labelsIn(std::string_view xml) {
  std::vector<Label> labels;
  constexpr std::string_view open = "<Label ", close = "</Label>";
  for (std::size_t at = xml.find(open); at != std::string_view::npos; at = xml.find(open, at + 1)) {
    const std::size_t tagEnd = xml.find('>', at);
    if (tagEnd == std::string_view::npos) break;
    const std::size_t end = xml.find(close, tagEnd);
    if (end == std::string_view::npos) break;
    const std::string_view tag = xml.substr(at + open.size() - 1, tagEnd - at - open.size() + 1);
    const auto key = attribute(tag, "Key");
    const auto value = key ? numberIn<std::uint16_t>(*key) : std::nullopt;
    if (value && *value > 0)
      labels.push_back(
          {*value, plainContent(xml.substr(tagEnd + 1, end - tagEnd - 1)), colourOf(tag).value_or(noColour)});
    at = end;
  }
  return labels;
}

}  // namespace

std::vector<Label> niftiLabels(const ImageFile& image) {
  const fs::path header = isPairImage(image.path) ? pairPartner(image.path, ".hdr") : image.path;
  const bool single = image.source.files.front() == header;
  const auto stream = openMaybeGzip(header);
  const bool swapped = image.bigEndian != (std::endian::native == std::endian::big);
  std::uint64_t at = 0;
  const auto read = [&](std::span<std::byte> into) {
    at += into.size();
    return stream->read(into.data(), into.size()) == into.size();
  };
  const auto number = [&](std::span<const std::byte, 4> bytes) {
    std::int32_t value = 0;
    std::memcpy(&value, bytes.data(), sizeof value);
    return swapped ? byteSwapped(value) : value;
  };
  std::array<std::byte, 4> word{};
  if (!read(word)) return {};
  const std::int32_t headerBytes = number(word);  // 348 or 540: the header has been read
  stream->skip(static_cast<std::uint64_t>(headerBytes) - word.size());
  at = static_cast<std::uint64_t>(headerBytes);
  if (!read(word) || word[0] == std::byte{0}) return {};
  // In a single file the voxels end the extensions, in a header of a pair the file's end.
  const std::uint64_t last =
      single ? static_cast<std::uint64_t>(image.source.skip) : std::numeric_limits<std::uint64_t>::max();
  std::array<std::byte, 4> code{};
  while (at + 8 <= last && read(word) && read(code)) {
    const std::int32_t bytes = number(word);
    if (bytes < 8 || bytes > longestExtension || at - 8 + static_cast<std::uint64_t>(bytes) > last) return {};
    std::string text(static_cast<std::size_t>(bytes) - 8, '\0');
    if (!read(std::as_writable_bytes(std::span(text)))) return {};
    const std::int32_t kind = number(code);
    // TotalSegmentator's are of no registered kind (0), Workbench's of Caret's (30).
    if ((kind == 0 || kind == 30) && text.find("<LabelTable") != std::string::npos) return labelsIn(text);
  }
  return {};
}

}  // namespace fenestra::io
