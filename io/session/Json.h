#pragma once
// JSON from untrusted files: parses within bounds, reads member by member, reports the place of every mistake, and
// writes numbers so that they come back bit for bit. Private to io/session.
//
// An overload of members(io, object) lists a struct's members once: io("size", view.size, {1.0, 16384.0}, {"Pixels"}).
// A Reader, a Writer and a SchemaWriter (JsonSchema.h) all run it. A member that is missing keeps its default.

#include <array>
#include <cmath>
#include <concepts>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include "io/base/Error.h"
#include "rendering/settings/Settings.h"

namespace fenestra::io::json {

using Value = nlohmann::ordered_json;

/// The whole of a regular file, of `most` bytes at most. Throws Error.
std::string readBounded(const std::filesystem::path& file, std::uintmax_t most);

/// Parses `text`. Throws Error when it is not JSON, nests deeper than 32, holds more than four million values or a
/// thousand members in one object, or repeats a member. These limits bound time and memory for any text.
Value parse(const std::filesystem::path& file, std::string_view text);

/// Indented, with numbers that bring back the same double.
std::string textOf(const Value& value);

/// Members of objects, at any level, that `read` has and `known` lacks; `known` was written from what a Reader took
/// from `read`. Null when there are none.
Value unknownIn(const Value& read, const Value& known);
/// Adds to `written` what unknownIn found. An element of a list gets back the unknown members of the element that
/// equals it, or else, in a list that kept its length, of the element in its place.
void addUnknown(Value& written, const Value& unknown);

/// Where in a file a value is, for messages.
struct Place {
  const std::filesystem::path& file;
  const Place* parent = nullptr;
  std::string_view key = {};
  std::size_t index = 0;  ///< in a list, when there is no key

  [[noreturn]] void fail(const std::string& problem) const;
};

inline constexpr Range nonNegative{0.0, std::numeric_limits<double>::max()};
inline constexpr Range positive{std::numeric_limits<double>::min(), std::numeric_limits<double>::max()};

/// What a member means, for the published schema.
struct Meaning {
  const char* text = "";
  const char* unit = "";
};

/// The argument of members(): T when reading, const T when writing.
template <class T, class U>
concept Is = std::same_as<std::remove_const_t<T>, U>;

/// A type whose values wordsOf() names.
template <class T>
concept Enumeration = std::is_enum_v<T>;

class Reader;
class Writer;
template <class T>
concept Object = requires(T& object, Reader& reader) {
  members(reader, object);
};

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsArray : std::false_type {};
template <class T, std::size_t N>
struct IsArray<std::array<T, N>> : std::true_type {};
template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

template <class T>
void read(const Place& place, const Value& json, T& value, Range range);
/// Throws std::invalid_argument for NaN and infinities, which JSON does not have.
template <class T>
Value write(const T& value);

class Reader {
 public:
  Reader(const Place& place, const Value& object) : place_(place), object_(object) {
    if (!object.is_object()) place.fail("is not an object");
  }

  bool has(const char* key) const { return object_.contains(key); }
  /// The member itself; null when it is missing.
  const Value& operator[](const char* key) const {
    static const Value none;
    const auto at = object_.find(key);
    return at == object_.end() ? none : *at;
  }
  template <class T>
  void operator()(const char* key, T& value, Range range = {}, Meaning = {}) const {
    const auto at = object_.find(key);
    if (at != object_.end()) read(Place{place_.file, &place_, key}, *at, value, range);
  }
  /// As operator(), for a member that must be there.
  template <class T>
  void required(const char* key, T& value, Range range = {}, Meaning = {}) const {
    if (!has(key)) place_.fail(std::string("lacks \"").append(key).append("\""));
    (*this)(key, value, range);
  }
  /// As operator(), for a member that is written only where `there` is something.
  template <class T>
  void optional(const char* key, T& value, bool, Range range = {}, Meaning = {}) const {
    (*this)(key, value, range);
  }
  [[noreturn]] void fail(const std::string& problem) const { place_.fail(problem); }

 private:
  const Place& place_;
  const Value& object_;
};

class Writer {
 public:
  explicit Writer(Value& object) : object_(object) { object_ = Value::object(); }

  template <class T>
  void operator()(const char* key, const T& value, Range = {}, Meaning = {}) {
    object_[key] = write(value);
  }
  template <class T>
  void required(const char* key, const T& value, Range = {}, Meaning = {}) {
    object_[key] = write(value);
  }
  template <class T>
  void optional(const char* key, const T& value, bool there, Range = {}, Meaning = {}) {
    if (there) object_[key] = write(value);
  }

 private:
  Value& object_;
};

template <class T>
void read(const Place& place, const Value& json, T& value, Range range) {
  if constexpr (std::same_as<T, bool>) {
    if (!json.is_boolean()) place.fail("is neither true nor false");
    value = json.get<bool>();
  } else if constexpr (std::integral<T>) {
    if (!json.is_number_integer()) place.fail("is not a whole number");
    const bool fits = json.is_number_unsigned() ? std::in_range<T>(json.get<std::uint64_t>())
                                                : std::in_range<T>(json.get<std::int64_t>());
    const double number = json.get<double>();
    if (!fits || !range.contains(number)) place.fail("is out of range");
    value = json.get<T>();
  } else if constexpr (std::same_as<T, double>) {
    if (!json.is_number()) place.fail("is not a number");
    const double number = json.get<double>();
    if (!std::isfinite(number) || !range.contains(number)) place.fail("is out of range");
    value = number;
  } else if constexpr (std::same_as<T, std::string> || std::same_as<T, std::filesystem::path>) {
    if (!json.is_string()) place.fail("is not a text");
    value = json.get<std::string>();
  } else if constexpr (Enumeration<T>) {
    std::string words;
    for (const Word<T>& each : wordsOf(T{})) {
      if (json == each.word) {
        value = each.value;
        return;
      }
      words.append(words.empty() ? "" : ", ").append(each.word);
    }
    place.fail("is none of " + words);
  } else if constexpr (IsOptional<T>::value) {
    if (json.is_null()) {
      value.reset();
    } else {
      read(place, json, value.emplace(), range);
    }
  } else if constexpr (IsVector<T>::value) {
    if (!json.is_array()) place.fail("is not a list");
    value.clear();
    value.reserve(json.size());
    for (std::size_t i = 0; i < json.size(); ++i)
      read(Place{place.file, &place, {}, i}, json[i], value.emplace_back(), range);
  } else if constexpr (IsArray<T>::value) {
    if (!json.is_array() || json.size() != value.size()) place.fail("is not a list of " + std::to_string(value.size()));
    for (std::size_t i = 0; i < value.size(); ++i) read(Place{place.file, &place, {}, i}, json[i], value[i], range);
  } else if constexpr (Object<T>) {
    Reader reader(place, json);
    members(reader, value);
  } else {  // a vector of GLM
    const auto size = static_cast<std::size_t>(value.length());
    if (!json.is_array() || json.size() != size) place.fail("is not a list of " + std::to_string(size));
    for (std::size_t i = 0; i < size; ++i)
      read(Place{place.file, &place, {}, i}, json[i], value[static_cast<int>(i)], range);
  }
}

template <class T>
Value write(const T& value) {
  if constexpr (Enumeration<T>) {
    return wordOf(value).word;
  } else if constexpr (IsOptional<T>::value) {
    return value ? write(*value) : Value();
  } else if constexpr (IsVector<T>::value || IsArray<T>::value) {
    Value list = Value::array();
    for (const auto& each : value) list.push_back(write(each));
    return list;
  } else if constexpr (std::same_as<T, double>) {
    if (!std::isfinite(value)) throw std::invalid_argument("a number that is not finite");
    return value;
  } else if constexpr (std::integral<T> || std::same_as<T, std::string>) {
    return value;
  } else if constexpr (std::same_as<T, std::filesystem::path>) {
    return value.generic_string();
  } else if constexpr (Object<T>) {
    Value object;
    Writer writer(object);
    members(writer, value);
    return object;
  } else {
    Value list = Value::array();
    for (int i = 0; i < value.length(); ++i) list.push_back(write(value[i]));
    return list;
  }
}

}  // namespace fenestra::io::json
