#pragma once
// Options made from the declarations of settings (rendering/scene/Settings.h): name, form, range, help text and
// default.

#include "app/OptionHelpers.h"
#include "rendering/scene/Settings.h"

namespace fenestra::app {

/// Decimal, with as few digits as bring back the same double.
inline std::string textOf(double number) {
  std::array<char, 400> digits;  // the largest double has 309 before the point
  const auto [end, error] = std::to_chars(digits.begin(), digits.end(), number, std::chars_format::fixed);
  return {digits.begin(), end};
}
inline std::string textOf(glm::dvec3 colour) {
  return textOf(colour.r) + "," + textOf(colour.g) + "," + textOf(colour.b);
}
inline std::string textOf(bool on) { return on ? "on" : "off"; }
template <class E>
requires std::is_enum_v<E> std::string textOf(E value) { return wordOf(value).word; }

/// An option that takes one of an enumeration's words.
template <class E, class Target>
CLI::Option* addChoice(CLI::App& command, const std::string& name, const std::string& description, Target& target) {
  std::vector<std::pair<std::string, E>> choices;
  for (const Word<E>& each : wordsOf(E{})) choices.emplace_back(each.word, each.value);
  return addChoice<E>(command, name, description, std::move(choices), target);
}

/// What --help says of a setting: its description, unit and default.
template <class Owner, class Value>
std::string helpOf(const Setting<Owner, Value>& setting) {
  std::string help = setting.description;
  help[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(help[0])));
  if (*setting.unit) help.append(", in ").append(setting.unit);
  if (std::same_as<Value, glm::dvec3>) help += ", display RGB of 0..1 each";
  return help + "; default " + textOf(Owner{}.*setting.member);
}

template <class Owner, class Value>
void addSetting(CLI::App& command, const Setting<Owner, Value>& setting, Value& target) {
  const std::string help = helpOf(setting);
  if constexpr (std::same_as<Value, bool>)
    addSwitch(command, setting.option, help, target);
  else if constexpr (std::same_as<Value, glm::dvec3>)
    addColour(command, setting.option, help, target);
  else if constexpr (std::is_enum_v<Value>)
    addChoice<Value>(command, setting.option, help, target);
  else
    addNumber(command, setting.option, setting.range.low, setting.range.high,
              textOf(setting.range.low) + ".." + textOf(setting.range.high), help, target);
}

/// One option for two numbers, as in AZIMUTH,ELEVATION.
template <class Owner>
void addPair(CLI::App& command, const std::string& name, const std::string& form, const Setting<Owner, double>& first,
             const Setting<Owner, double>& second, Owner& target) {
  addParsed(command, name, form, helpOf(first) + "; " + helpOf(second), [=, &target](const std::string& text) {
    const auto numbers = parseNumbers<double, 2>(text, ',');
    if (!numbers || !first.range.contains((*numbers)[0]) || !second.range.contains((*numbers)[1])) return false;
    target.*first.member = (*numbers)[0];
    target.*second.member = (*numbers)[1];
    return true;
  });
}

/// All settings of `target` that have an option.
template <class Owner>
void addSettings(CLI::App& command, Owner& target) {
  forEachSetting<Owner>([&](const auto& setting) {
    if (setting.option) addSetting(command, setting, target.*setting.member);
  });
}

}  // namespace fenestra::app
