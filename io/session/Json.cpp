#include "io/session/Json.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <system_error>

namespace fenestra::io::json {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t deepest = 32, mostValues = std::size_t{1} << 22, mostMembers = 1000;
constexpr const char* damagedHint = "the file is damaged or not a file of Fenestra; use an older copy of it";

/// Counts what a parser would have to hold, without holding it. Text that is not JSON passes; the parser refuses it.
void checkBounds(const fs::path& file, std::string_view text) {
  struct Container {
    bool object;
    std::size_t commas;
  };
  std::vector<Container> open;
  std::size_t values = 0;
  bool inText = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inText) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        inText = false;
      continue;
    }
    switch (c) {
      case '"':
        inText = true;
        break;
      case '{':
      case '[':
        if (open.size() == deepest) throw Error(file, "nests too deep", damagedHint);
        open.push_back({c == '{', 0});
        ++values;
        break;
      case '}':
      case ']':
        if (!open.empty()) open.pop_back();
        break;
      case ',':
        ++values;
        if (!open.empty() && ++open.back().commas == mostMembers && open.back().object)
          throw Error(file, "has an object of too many members", damagedHint);
        break;
      default:
        break;
    }
    if (values > mostValues) throw Error(file, "holds too many values", damagedHint);
  }
}

/// Whether `whole` contains everything in `known`.
bool agrees(const Value& whole, const Value& known) {
  if (!known.is_object() || !whole.is_object()) return whole == known;
  return std::all_of(known.items().begin(), known.items().end(), [&](const auto& member) {
    const auto at = whole.find(member.key());
    return at != whole.end() && agrees(*at, member.value());
  });
}

}  // namespace

std::string readBounded(const fs::path& file, std::uintmax_t most) {
  std::error_code failure;
  if (!fs::exists(file, failure)) throw Error(file, "does not exist", "check the path");
  if (!fs::is_regular_file(file, failure)) throw Error(file, "is not a file", "check the path");
  const std::uintmax_t size = fs::file_size(file, failure);
  if (failure) throw Error(file, "cannot be read: " + failure.message(), "check its permissions");
  if (size > most)
    throw Error(file, "is larger than " + std::to_string(most >> 20) + " MB, more than Fenestra writes", damagedHint);
  std::ifstream stream(file, std::ios::binary);
  std::string text(size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(stream.gcount()) != size)
    throw Error(file, "cannot be read", "check its permissions");
  return text;
}

Value parse(const fs::path& file, std::string_view text) {
  checkBounds(file, text);
  std::vector<std::set<std::string>> members;
  const auto watch = [&](int, Value::parse_event_t event, Value& parsed) {
    if (event == Value::parse_event_t::object_start) {
      members.emplace_back();
    } else if (event == Value::parse_event_t::object_end) {
      members.pop_back();
    } else if (event == Value::parse_event_t::key && !members.back().insert(parsed.get<std::string>()).second) {
      throw Error(file, "has the member " + parsed.dump().substr(0, 60) + " twice", damagedHint);
    }
    return true;
  };
  try {
    return Value::parse(text, watch);
  } catch (const Value::parse_error& error) {
    throw Error(file, "is not valid JSON near byte " + std::to_string(error.byte), damagedHint);
  } catch (const Value::out_of_range&) {
    throw Error(file, "holds a number that no double can hold", damagedHint);
  }
}

std::string textOf(const Value& value) { return value.dump(1) + "\n"; }

Value unknownIn(const Value& read, const Value& known) {
  if (read.is_object() && known.is_object()) {
    Value unknown;
    for (const auto& [key, value] : read.items()) {
      const auto at = known.find(key);
      Value rest = at == known.end() ? value : unknownIn(value, *at);
      if (at == known.end() || !rest.is_null()) unknown[key] = std::move(rest);
    }
    return unknown;
  }
  if (!read.is_array() || !known.is_array()) return {};
  for (std::size_t i = 0; i < std::min(read.size(), known.size()); ++i)
    if (!unknownIn(read[i], known[i]).is_null()) return read;
  return {};
}

void addUnknown(Value& written, const Value& unknown) {
  if (written.is_object() && unknown.is_object()) {
    for (const auto& [key, value] : unknown.items()) {
      const auto at = written.find(key);
      if (at == written.end())
        written[key] = value;
      else
        addUnknown(*at, value);
    }
  } else if (written.is_array() && unknown.is_array()) {
    // Remaining elements keep their order, so each search starts behind the last match. It is short, because a list
    // with no remaining element would otherwise take quadratic time.
    constexpr std::size_t reach = 1000;
    std::size_t next = 0;
    for (std::size_t i = 0; i < written.size(); ++i) {
      const std::size_t end = std::min(unknown.size(), next + reach);
      std::size_t same = next;
      while (same < end && !agrees(unknown[same], written[i])) ++same;
      if (same < end)
        next = same + 1;
      else if (written.size() == unknown.size())
        same = i;
      else
        continue;
      if (written[i].is_structured()) addUnknown(written[i], unknown[same]);
    }
  }
}

void Place::fail(const std::string& problem) const {
  std::string where;
  for (const Place* at = this; at->parent; at = at->parent)
    where.insert(0, std::string("/").append(at->key.empty() ? std::to_string(at->index) : std::string(at->key)));
  throw Error(file, where.empty() ? "the top level " + problem : "\"" + where + "\" " + problem, damagedHint);
}

}  // namespace fenestra::io::json
