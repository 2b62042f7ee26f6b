#include "io/archive/WebAnswers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "io/base/Text.h"
#include "io/dicom/Dcmtk.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io::archive {
namespace {

using Json = nlohmann::json;

/// The keyword of "00100010"; empty for attributes that are private or unknown.
std::string keywordOf(const std::string& tag) {
  std::uint32_t number = 0;
  const auto [end, failure] = std::from_chars(tag.data(), tag.data() + tag.size(), number, 16);
  if (tag.size() != 8 || failure != std::errc() || end != tag.data() + tag.size()) return {};
  DcmTag known(static_cast<Uint16>(number >> 16), static_cast<Uint16>(number & 0xffff));
  const std::string name = known.getTagName();
  return name == "Unknown Tag & Data" || known.isPrivate() ? std::string() : name;
}

/// The groups of a person's name (PS3.18 F.2.2).
std::string nameIn(const Json& value) {
  std::string name;
  std::size_t written = 0, group = 0;
  for (const char* each : {"Alphabetic", "Ideographic", "Phonetic"}) {
    ++group;
    const auto at = value.find(each);
    if (at == value.end() || !at->is_string() || at->get_ref<const std::string&>().empty()) continue;
    name.append(written == 0 ? group - 1 : group - written, '=').append(*at);
    written = group;
  }
  return name;
}

std::string textIn(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_unsigned()) return std::to_string(value.get<std::uint64_t>());
  if (value.is_number_integer()) return std::to_string(value.get<std::int64_t>());
  if (value.is_number()) return plainNumber(value.get<double>());
  if (value.is_object()) return nameIn(value);
  return {};
}

Attributes attributesIn(const Json& dataset) {
  Attributes attributes;
  for (const auto& [tag, element] : dataset.items()) {
    if (!element.is_object() || tag == "00080005") continue;
    const auto vr = element.find("vr"), values = element.find("Value");
    if (vr == element.end() || *vr == "SQ" || values == element.end() || !values->is_array()) continue;
    std::string text;
    for (std::size_t i = 0; i < values->size(); ++i) text.append(i == 0 ? "" : "\\").append(textIn((*values)[i]));
    text = trimmed(text);
    if (text.find_first_not_of('\\') == std::string::npos) continue;
    if (const std::string keyword = keywordOf(tag); !keyword.empty()) attributes[keyword] = text;
  }
  return attributes;
}

/// Empty also for text that nests deeper than any answer does: its destruction would need as much of the stack.
std::optional<Json> parsed(std::string_view text) {
  constexpr int deepest = 64;
  bool isTooDeep = false;
  const auto watch = [&](int depth, Json::parse_event_t, Json&) {
    isTooDeep = isTooDeep || depth > deepest;
    return depth <= deepest;
  };
  Json json = Json::parse(text, watch, false);
  if (json.is_discarded() || isTooDeep) return std::nullopt;
  return json;
}

/// The values of an attribute; null where there are none.
const Json* valuesIn(const Json& dataset, const char* tag) {
  const auto at = dataset.find(tag);
  if (at == dataset.end() || !at->is_object()) return nullptr;
  const auto values = at->find("Value");
  return values != at->end() && values->is_array() && !values->empty() ? &*values : nullptr;
}

const Json* sequenceIn(const Json& dataset, const char* tag) {
  const Json* values = valuesIn(dataset, tag);
  return values && (*values)[0].is_object() ? &(*values)[0] : nullptr;
}

unsigned reasonIn(const Json& item, const char* tag) {
  const Json* values = valuesIn(item, tag);
  return values && (*values)[0].is_number_unsigned() ? (*values)[0].get<unsigned>() : 0;
}

/// Servers write decimal strings as numbers or as texts.
std::optional<double> numberIn(const Json& values, std::size_t at) {
  if (at >= values.size()) return std::nullopt;
  return values[at].is_number() || values[at].is_string() ? decimalIn(textIn(values[at])) : std::nullopt;
}

/// Empty where the attribute holds no whole number from 0 to `most`.
std::optional<int> countIn(const Json& dataset, const char* tag, int most) {
  const Json* values = valuesIn(dataset, tag);
  const auto number = values ? numberIn(*values, 0) : std::nullopt;
  if (!number || *number < 0.0 || *number > most || *number != std::floor(*number)) return std::nullopt;
  return static_cast<int>(*number);
}

std::string wordIn(const Json& dataset, const char* tag) {
  const Json* values = valuesIn(dataset, tag);
  return values && (*values)[0].is_string() ? trimmed((*values)[0].get<std::string>()) : std::string();
}

/// What the functional groups of a frame say, else the object itself: Pixel Spacing, Window Center and Width, Rescale
/// Intercept and Slope.
std::vector<FrameHeader::Value> meaningIn(const Json& object, int number) {
  struct Source {
    const char *group, *tag;
    std::uint32_t number;
    std::size_t count;
  };
  constexpr std::array<Source, 5> sources{{{"00289110", "00280030", 0x00280030, 2},
                                           {"00289132", "00281050", 0x00281050, 1},
                                           {"00289132", "00281051", 0x00281051, 1},
                                           {"00289145", "00281052", 0x00281052, 1},
                                           {"00289145", "00281053", 0x00281053, 1}}};
  const Json* own = valuesIn(object, "52009230");
  const auto at = static_cast<std::size_t>(number - 1);
  own = own && at < own->size() && (*own)[at].is_object() ? &(*own)[at] : nullptr;
  const Json* shared = sequenceIn(object, "52009229");
  std::vector<FrameHeader::Value> meaning;
  for (const Source& source : sources) {
    const Json* group = own ? sequenceIn(*own, source.group) : nullptr;
    if (!group && shared) group = sequenceIn(*shared, source.group);
    const Json* values = valuesIn(group ? *group : object, source.tag);
    FrameHeader::Value value{source.number, {}};
    for (std::size_t i = 0; values && i < source.count; ++i)
      if (const auto next = numberIn(*values, i)) value.numbers.push_back(*next);
    if (value.numbers.size() == source.count) meaning.push_back(std::move(value));
  }
  return meaning;
}

}  // namespace

std::optional<std::vector<Attributes>> attributesInJson(std::string_view text) {
  if (trimmed(text).empty()) return std::vector<Attributes>();  // of nothing found (HTTP 204)
  const std::optional<Json> json = parsed(text);
  if (!json || !json->is_array()) return std::nullopt;
  std::vector<Attributes> all;
  for (const Json& dataset : *json) {
    if (!dataset.is_object()) return std::nullopt;
    all.push_back(attributesIn(dataset));
  }
  return all;
}

std::optional<StoreAnswer> storeAnswerIn(std::string_view text) {
  std::optional<Json> json = parsed(text);
  if (json && json->is_array() && json->size() == 1) json = Json((*json)[0]);
  if (!json || !json->is_object()) return std::nullopt;
  if (const Json* failed = sequenceIn(*json, "00081198")) return StoreAnswer{false, reasonIn(*failed, "00081197")};
  if (const Json* stored = sequenceIn(*json, "00081199")) return StoreAnswer{true, reasonIn(*stored, "00081196")};
  return std::nullopt;
}

std::uint64_t FrameHeader::bytes() const {
  return static_cast<std::uint64_t>(rows) * static_cast<std::uint64_t>(columns) *
         static_cast<std::uint64_t>(bitsAllocated / 8);
}

std::optional<FrameHeader> frameHeaderIn(std::string_view text, int number) {
  const std::optional<Json> json = parsed(text);
  if (!json || !json->is_array() || json->size() != 1 || !(*json)[0].is_object()) return std::nullopt;
  const Json& object = (*json)[0];
  constexpr int most = 65535;  // of an attribute with VR US
  FrameHeader header;
  header.rows = countIn(object, "00280010", most).value_or(0);
  header.columns = countIn(object, "00280011", most).value_or(0);
  header.bitsAllocated = countIn(object, "00280100", most).value_or(0);
  header.bitsStored = countIn(object, "00280101", most).value_or(header.bitsAllocated);
  header.highBit = countIn(object, "00280102", most).value_or(header.bitsStored - 1);
  header.isSigned = countIn(object, "00280103", 1).value_or(0) == 1;
  header.photometric = wordIn(object, "00280004");
  header.modality = wordIn(object, "00080060");
  const int frames = countIn(object, "00280008", std::numeric_limits<int>::max()).value_or(1);
  const bool isWhole = header.bitsAllocated == 8 || header.bitsAllocated == 16 || header.bitsAllocated == 32;
  const bool isGrey = header.photometric.starts_with("MONOCHROME") && header.modality != "SEG" &&
                      countIn(object, "00280002", most).value_or(1) == 1;
  if (number < 1 || number > frames || header.rows < 1 || header.columns < 1 || !isWhole || !isGrey)
    return std::nullopt;
  header.meaning = meaningIn(object, number);
  return header;
}

}  // namespace fenestra::io::archive
