#include "app/LabelOptions.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/options/Numbers.h"

namespace fenestra::app {
namespace {

namespace fs = std::filesystem;

/// "#rrggbb" as display RGB.
std::optional<glm::dvec3> colourIn(const std::string& text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  unsigned code = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), code, 16);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return glm::dvec3(code >> 16, (code >> 8) & 255u, code & 255u) / 255.0;
}

std::optional<double> shareIn(const std::string& text) {
  const std::optional<double> share = parseNumber<double>(text);
  return share && *share >= 0.0 && *share <= 1.0 ? share : std::nullopt;
}

std::optional<int> levelIn(const std::string& text) {
  const std::optional<int> level = parseNumber<int>(text);
  return level && *level >= 0 && *level <= mostImportant ? level : std::nullopt;
}

/// LABEL=VALUE,… with values that `read` takes.
template <class T, class Read>
bool readPairs(const std::string& text, std::vector<std::pair<std::string, T>>& pairs, const Read& read) {
  pairs.clear();
  for (const std::string& part : io::split(text, ',')) {
    const std::size_t equals = part.rfind('=');
    if (equals == std::string::npos || equals == 0) return false;
    const std::optional<T> value = read(part.substr(equals + 1));
    if (!value) return false;
    pairs.emplace_back(part.substr(0, equals), *value);
  }
  return true;
}

void addLabelList(Command command, const char* name, const char* description, std::vector<std::string>& labels) {
  command.add(name, "LABEL,...", description, [&labels](const std::string& text) {
    labels = io::split(text, ',');
    return std::find(labels.begin(), labels.end(), "") == labels.end();
  });
}

/// [LABEL=]PRESET|FILE.json|none.
std::optional<io::LabelChanges::Function> functionIn(const std::string& text) {
  // A file's own name may hold an equals sign.
  const std::size_t equals = fs::is_regular_file(text) ? std::string::npos : text.rfind('=');
  io::LabelChanges::Function function{{}, text};
  if (equals != std::string::npos) function = {text.substr(0, equals), text.substr(equals + 1)};
  if (equals == 0 || function.source.empty()) return std::nullopt;
  if (function.source == "none") function.source.clear();
  return function;
}

}  // namespace

void addFocusTransfer(Command command, io::LabelChanges& changes) {
  const std::string form = "[LABEL=]PRESET|FILE.json|none";
  command.addRepeated(
      "--focus-transfer", form,
      "optical properties of the focus by value, as --transfer-function has those of all else: of one label, by "
      "value or name, or of all that is in focus. May be given several times. none: one colour and extinction",
      [form, &changes](const std::vector<std::string>& texts) {
        changes.functions.clear();
        for (const std::string& text : texts) {
          const auto function = functionIn(text);
          if (!function) throw WrongValue{"\"" + text + "\" is not " + form};
          changes.functions.push_back(*function);
        }
      });
}

void addLabelSettings(Command command, io::LabelChanges& changes) {
  addLabelList(command, "--hidden", "labels, by value or name, that 3-D pictures leave out", changes.hidden);
  addLabelList(command, "--protected", "labels, by value or name, that are never cut away, though they hide the focus",
               changes.guarded);
  command.add("--label-opacity", "LABEL=0..1,...", "opacity of the surface of labels, in focus or not; 0 hides",
              [&changes](const std::string& text) { return readPairs(text, changes.opacities, shareIn); });
  command.add("--label-colour", "LABEL=#rrggbb,...", "colours of labels, in place of the label map's",
              [&changes](const std::string& text) { return readPairs(text, changes.colours, colourIn); });
  command.add(
      "--importance-levels", "LABEL=0..4,...",
      "levels of importance of labels, by value or name, for the method importance: what hides a more important "
      "label is opened. Labels in focus have 4 by default, all else 0",
      [&changes](const std::string& text) { return readPairs(text, changes.importance, levelIn); });
}

}  // namespace fenestra::app
