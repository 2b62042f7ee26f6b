#include "app/LookOptions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <concepts>
#include <optional>
#include <string>

#include "app/options/Numbers.h"
#include "app/options/WordOptions.h"
#include "io/TransferFunctionFile.h"
#include "rendering/scene/Lighting.h"
#include "rendering/settings/LookStyle.h"
#include "rendering/settings/Settings.h"

namespace fenestra::app {
namespace {

/// Decimal, with as few digits as bring back the same double.
std::string textOf(double number) {
  std::array<char, 400> digits;  // the largest double has 309 before the point
  const auto [end, error] = std::to_chars(digits.begin(), digits.end(), number, std::chars_format::fixed);
  return {digits.begin(), end};
}
std::string textOf(glm::dvec3 colour) { return textOf(colour.r) + "," + textOf(colour.g) + "," + textOf(colour.b); }
std::string textOf(bool on) { return on ? "on" : "off"; }
template <class E>
requires std::is_enum_v<E> std::string textOf(E value) { return wordOf(value).word; }

/// What --help says of a setting: its description, unit and default.
template <class Owner, class Value>
std::string helpOf(const Setting<Owner, Value>& setting, const Value& otherwise) {
  std::string help = setting.description;
  help[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(help[0])));
  if (*setting.unit) help.append(", in ").append(setting.unit);
  if (std::same_as<Value, glm::dvec3>) help += ", display RGB of 0..1 each";
  return help + "; default " + textOf(otherwise);
}

template <class Owner, class Value>
void addSetting(Command command, const Setting<Owner, Value>& setting, Value& target) {
  const std::string help = helpOf(setting, target);
  if constexpr (std::same_as<Value, bool>)
    addSwitch(command, setting.option, help, target);
  else if constexpr (std::same_as<Value, glm::dvec3>)
    addColour(command, setting.option, help, target);
  else if constexpr (std::is_enum_v<Value>)
    addWords<Value>(command, setting.option, help, target);
  else
    addNumber(command, setting.option, setting.range.low, setting.range.high,
              textOf(setting.range.low) + ".." + textOf(setting.range.high), help, target);
}

/// One option for two numbers, as in AZIMUTH,ELEVATION.
template <class Owner>
void addPair(Command command, const std::string& name, const std::string& form, const Setting<Owner, double>& first,
             const Setting<Owner, double>& second, Owner& target) {
  command.add(name, form, helpOf(first, target.*first.member) + "; " + helpOf(second, target.*second.member),
              [=, &target](const std::string& text) {
                const auto numbers = parseNumbers<double, 2>(text, ',');
                if (!numbers || !first.range.contains((*numbers)[0]) || !second.range.contains((*numbers)[1]))
                  return false;
                target.*first.member = (*numbers)[0];
                target.*second.member = (*numbers)[1];
                return true;
              });
}

/// All settings of `target` that have an option.
template <class Owner>
void addSettings(Command command, Owner& target) {
  forEachSetting<Owner>([&](const auto& setting) {
    if (setting.option) addSetting(command, setting, target.*setting.member);
  });
}

/// To be added before the options of the light itself, which override it then.
void addLightPreset(Command command, Shading& shading) {
  std::string names;
  for (const LightPreset& each : lightPresets()) names.append(names.empty() ? "" : "|").append(each.id);
  command.add("--light-preset", names, "light ready made, from wherever it comes; default standard",
              [&shading](const std::string& text) {
                const auto all = lightPresets();
                const auto chosen =
                    std::find_if(all.begin(), all.end(), [&](const LightPreset& each) { return each.id == text; });
                if (chosen == all.end()) return false;
                chosen->applyTo(shading);
                return true;
              });
}

}  // namespace

void addLookOptions(Command command, io::StudyRequest& request) {
  Look& look = request.look;
  std::string presets;
  for (const io::TransferFunctionPreset& preset : io::transferFunctionPresets())
    presets.append(presets.empty() ? "" : "|").append(preset.id);
  command.addValue("--transfer-function", request.transferFunction, "optical properties of everything but the focus")
      .as(presets + "|FILE.json");
  // Options apply in the order in which they are added: --look first, so that a width given beside it overrides it.
  std::string looks = "starting|plain";
  for (const OpeningLook& each : openingLooks()) looks.append("|").append(each.id);
  command.add(
      "--look", looks + "|FILE.json",
      "starting is what the window opens new data in, plain has no smoothing, occlusion and shadow, bare has no border "
      "and edges either; others: context layer and border ready made; or a preset that was saved, with its transfer "
      "function, light and all",
      [&](const std::string& text) {
        if (std::filesystem::path(text).extension() == ".json") {
          request.preset = io::readLook(text);
          look = restyled(look, request.preset->look);
          return true;
        }
        if (text == "starting") return request.makeStarting(), true;
        if (text == "plain") return request.makePlain(), true;
        if (text == "bare") return request.makeBare(), true;
        const auto all = openingLooks();
        const auto chosen =
            std::find_if(all.begin(), all.end(), [&](const OpeningLook& each) { return each.id == text; });
        if (chosen == all.end()) return false;
        chosen->applyTo(look.cutaway, look.contextLayer);
        return true;
      });
  addLightPreset(command, look.shading);
  addSettings(command, look.method);
  forEachMethod([&]<class M>() { addSettings(command, look.method.of<M>()); });
  addSettings(command, look.cutaway);
  addSettings(command, look.contextLayer);
  addSettings(command, look.shading);
  addPair(command, "--light", "AZIMUTH,ELEVATION", settingOf(&Shading::lightAzimuth),
          settingOf(&Shading::lightElevation), look.shading);
  addSettings(command, look);
  command.add("--strokes", "FILE.json", "brush strokes to apply, in place of a session's",
              [&request](const std::string& text) {
                request.strokes = text;
                return !text.empty();
              });
}

void addSamplingOptions(Command command, io::StudyRequest& request) {
  // A session's greatest error gives way to a quality.
  command.add("--quality", formOf<Quality>(), "default normal", [&request](const std::string& text) {
    request.maxError.reset();
    return takeWord<Quality>(text, request.quality);
  });
  command.add("--max-error", "E",
              "greatest error of a colour that sampling may leave, in 1/255, from " + textOf(maxErrors.low) + " up",
              [&request](const std::string& text) {
                const std::optional<double> error = parseNumber<double>(text);
                if (!error || !maxErrors.contains(*error)) return false;
                request.maxError = error;
                return true;
              });
}

void addMinimumSize(Command command, double& target) {
  addSetting(command, settingOf(&ValueFocus::minimumComponent), target);
}

}  // namespace fenestra::app
