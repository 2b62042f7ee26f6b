#include "io/archive/WebAnswers.h"

#include <array>
#include <charconv>

#include <nlohmann/json.hpp>

#include "io/base/Text.h"
#include "io/dicom/Dcmtk.h"

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

const Json* sequenceIn(const Json& dataset, const char* tag) {
  const auto at = dataset.find(tag);
  if (at == dataset.end() || !at->is_object()) return nullptr;
  const auto values = at->find("Value");
  return values != at->end() && values->is_array() && !values->empty() && (*values)[0].is_object() ? &(*values)[0]
                                                                                                   : nullptr;
}

unsigned reasonIn(const Json& item, const char* tag) {
  const auto at = item.find(tag);
  if (at == item.end() || !at->is_object()) return 0;
  const auto values = at->find("Value");
  const bool isThere = values != at->end() && values->is_array() && !values->empty();
  return isThere && (*values)[0].is_number_unsigned() ? (*values)[0].get<unsigned>() : 0;
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

}  // namespace fenestra::io::archive
