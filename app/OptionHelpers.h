#pragma once
// Options whose values are checked while the command line is parsed, with uniform messages. Numbers have a decimal
// point in every locale.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
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

/// An option whose text `parse` turns into a value or nothing; `form` says what was expected.
template <class Parse>
CLI::Option* addParsed(CLI::App& command, const std::string& name, const std::string& form,
                       const std::string& description, Parse parse) {
  return command
      .add_option_function<std::string>(
          name,
          [=](const std::string& text) {
            if (!parse(text)) throw CLI::ValidationError(name, "\"" + text + "\" is not " + form);
          },
          description)
      ->type_name(form);
}

inline CLI::Option* addNumber(CLI::App& command, const std::string& name, double low, double high,
                              const std::string& form, const std::string& description, double& target) {
  return addParsed(command, name, form, description, [=, &target](const std::string& text) {
    const std::optional<double> number = parseNumber<double>(text);
    if (!number || *number < low || *number > high) return false;
    target = *number;
    return true;
  });
}

inline CLI::Option* addSwitch(CLI::App& command, const std::string& name, const std::string& description,
                              bool& target) {
  return addParsed(command, name, "on|off", description, [&target](const std::string& text) {
    target = text == "on";
    return target || text == "off";
  });
}

inline CLI::Option* addColour(CLI::App& command, const std::string& name, const std::string& description,
                              glm::dvec3& target) {
  return addParsed(command, name, "R,G,B", description, [&target](const std::string& text) {
    const auto colour = parseNumbers<double, 3>(text, ',');
    if (!colour || std::any_of(colour->begin(), colour->end(), [](double c) { return c < 0.0 || c > 1.0; }))
      return false;
    target = {(*colour)[0], (*colour)[1], (*colour)[2]};
    return true;
  });
}

/// An option that takes one of a few words.
template <class T, class Target>
CLI::Option* addChoice(CLI::App& command, const std::string& name, const std::string& description,
                       std::vector<std::pair<std::string, T>> choices, Target& target) {
  std::string form;
  for (const auto& [word, value] : choices) form += (form.empty() ? "" : "|") + word;
  return addParsed(command, name, form, description, [&target, choices](const std::string& text) {
    const auto at =
        std::find_if(choices.begin(), choices.end(), [&](const auto& choice) { return choice.first == text; });
    if (at == choices.end()) return false;
    target = at->second;
    return true;
  });
}

}  // namespace fenestra::app
