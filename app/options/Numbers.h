#pragma once
// Numbers in the values of options, with a decimal point in every locale.

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <glm/glm.hpp>

#include "io/base/Text.h"

namespace fenestra::app {

/// The whole of `text` as a finite number, or nothing.
template <class T>
std::optional<T> parseNumber(std::string_view text) {
  const std::optional<T> value = io::numberIn<T>(text);
  if constexpr (std::is_floating_point_v<T>)
    if (value && !std::isfinite(*value)) return std::nullopt;
  return value;
}

/// Exactly N numbers between separators.
template <class T, std::size_t N>
std::optional<std::array<T, N>> parseNumbers(const std::string& text, char separator) {
  const std::vector<std::string> parts = io::split(text, separator);
  if (parts.size() != N) return std::nullopt;
  std::array<T, N> numbers{};
  for (std::size_t i = 0; i < N; ++i) {
    const std::optional<T> number = parseNumber<T>(parts[i]);
    if (!number) return std::nullopt;
    numbers[i] = *number;
  }
  return numbers;
}

/// "X,Y,Z"
inline std::optional<glm::dvec3> parseVector(const std::string& text) {
  const auto numbers = parseNumbers<double, 3>(text, ',');
  if (!numbers) return std::nullopt;
  return glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

/// "WxH", each from 1 to `most`.
inline std::optional<glm::ivec2> parseSize(const std::string& text, int most) {
  const auto size = parseNumbers<int, 2>(text, 'x');
  if (!size || (*size)[0] < 1 || (*size)[1] < 1 || (*size)[0] > most || (*size)[1] > most) return std::nullopt;
  return glm::ivec2((*size)[0], (*size)[1]);
}

}  // namespace fenestra::app
