#pragma once
// A JSON Schema (2020-12) of what a Reader takes, from the same members(). Private to io/session.

#include "io/session/Json.h"

namespace fenestra::io::json {

/// Whole numbers without a fraction, as people write them.
inline Value plainNumber(double number) {
  const auto whole = static_cast<std::int64_t>(std::clamp(number, -1e15, 1e15));
  return static_cast<double>(whole) == number ? Value(whole) : Value(number);
}

/// The schema of a value of type T whose numbers lie in `range`; `example` gives the defaults of an object's members.
template <class T>
Value schemaOf(const T& example, Range range = {});

/// Collects the schema of an object's members.
class SchemaWriter {
 public:
  /// A member that may be missing: its default is `value`.
  template <class T>
  void operator()(const char* key, const T& value, Range range = {}, Meaning meaning = {}) {
    Value& schema = add(key, schemaOf(value, range), meaning);
    if constexpr (std::same_as<T, double>)
      schema["default"] = plainNumber(value);
    else if constexpr (std::integral<T> || Enumeration<T>)
      schema["default"] = write(value);
    else if constexpr (std::same_as<T, glm::dvec3>)
      schema["default"] = {plainNumber(value.x), plainNumber(value.y), plainNumber(value.z)};
  }
  template <class T>
  void required(const char* key, const T& value, Range range = {}, Meaning meaning = {}) {
    add(key, schemaOf(value, range), meaning);
    required_.push_back(key);
  }
  /// A member that stands for nothing where it is missing.
  template <class T>
  void optional(const char* key, const T& value, bool, Range range = {}, Meaning meaning = {}) {
    add(key, schemaOf(value, range), meaning);
  }
  /// A member that is an object of one of several kinds, or missing.
  template <class... Kinds>
  void oneOf(const char* key, Meaning meaning) {
    add(key, {{"oneOf", {schemaOf(Kinds{})...}}}, meaning);
  }

  Value schema() const {
    Value schema{{"type", "object"}};
    if (!required_.empty()) schema["required"] = required_;
    schema["properties"] = properties_;
    return schema;
  }

 private:
  Value& add(const char* key, Value schema, Meaning meaning) {
    std::string text = meaning.text;
    if (*meaning.unit) text.append(text.empty() ? "" : ", in ").append(meaning.unit);
    if (!text.empty()) schema["description"] = text;
    return properties_[key] = std::move(schema);
  }

  Value properties_ = Value::object();
  std::vector<std::string> required_;
};

inline void addRange(Value& schema, Range range) {
  if (range.low == std::numeric_limits<double>::min())
    schema["exclusiveMinimum"] = 0;
  else if (range.low != Range().low)
    schema["minimum"] = plainNumber(range.low);
  if (range.high != Range().high) schema["maximum"] = plainNumber(range.high);
}

template <class T>
Value schemaOf(const T& example, Range range) {
  if constexpr (std::same_as<T, bool>) {
    return {{"type", "boolean"}};
  } else if constexpr (std::integral<T> || std::same_as<T, double>) {
    Value schema{{"type", std::integral<T> ? "integer" : "number"}};
    if (std::unsigned_integral<T>) range.low = std::max(range.low, 0.0);
    addRange(schema, range);
    return schema;
  } else if constexpr (std::same_as<T, std::string>) {
    return {{"type", "string"}};
  } else if constexpr (std::same_as<T, std::filesystem::path>) {
    return {{"$ref", "#/$defs/path"}};
  } else if constexpr (Enumeration<T>) {
    Value words = Value::array();
    for (const Word<T>& each : wordsOf(T{})) words.push_back(each.word);
    return {{"enum", std::move(words)}};
  } else if constexpr (IsOptional<T>::value) {
    return schemaOf(typename T::value_type{}, range);
  } else if constexpr (IsVector<T>::value) {
    return {{"type", "array"}, {"items", schemaOf(typename T::value_type{}, range)}};
  } else if constexpr (Object<T>) {
    SchemaWriter writer;
    members(writer, example);
    return writer.schema();
  } else {  // an array, or a vector of GLM
    std::size_t size = 0;
    if constexpr (IsArray<T>::value)
      size = example.size();
    else
      size = static_cast<std::size_t>(example.length());
    return {{"type", "array"}, {"items", schemaOf(example[0], range)}, {"minItems", size}, {"maxItems", size}};
  }
}

}  // namespace fenestra::io::json
