#include "app/LabelOptions.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <CLI/CLI.hpp>

#include "app/OptionHelpers.h"
#include "io/TransferFunctionFile.h"

namespace fenestra::app {
namespace {

namespace fs = std::filesystem;

/// Number of insertions, deletions and replacements that turn a into b (Levenshtein).
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string described(const Label& label) { return std::to_string(label.value) + " " + label.name; }

/// The labels most like `wanted`: by name, or by value when it is a number.
std::string nearestLabels(const LabelMap& labels, const std::string& wanted) {
  const std::optional<long> number = parseNumber<long>(wanted);
  const auto distance = [&](const Label& label) -> std::size_t {
    if (number) return static_cast<std::size_t>(std::abs(*number - static_cast<long>(label.value)));
    const std::string name = io::lowered(label.name), part = io::lowered(wanted);
    return name.find(part) != std::string::npos ? 0 : editDistance(name, part);
  };
  std::vector<const Label*> order;
  for (const Label& label : labels.labels) order.push_back(&label);
  std::stable_sort(order.begin(), order.end(), [&](auto* a, auto* b) { return distance(*a) < distance(*b); });
  std::string text;
  constexpr std::size_t shown = 3;
  for (std::size_t i = 0; i < std::min(shown, order.size()); ++i) text += (i ? ", " : "") + described(*order[i]);
  return text;
}

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

void addLabelList(CLI::App& command, const char* name, const char* description, std::vector<std::string>& labels) {
  addParsed(command, name, "LABEL,...", description, [&labels](const std::string& text) {
    labels = io::split(text, ',');
    return std::find(labels.begin(), labels.end(), "") == labels.end();
  });
}

/// [LABEL=]PRESET|FILE.json|none.
std::optional<LabelChanges::Function> functionIn(const std::string& text) {
  // A file's own name may hold an equals sign.
  const std::size_t equals = fs::is_regular_file(text) ? std::string::npos : text.rfind('=');
  LabelChanges::Function function{{}, text};
  if (equals != std::string::npos) function = {text.substr(0, equals), text.substr(equals + 1)};
  if (equals == 0 || function.source.empty()) return std::nullopt;
  if (function.source == "none") function.source.clear();
  return function;
}

fs::path labelFile(const SceneOptions& options) {
  return options.labels.empty() ? fs::path(options.source()) : options.labels;
}

}  // namespace

void addFocusTransfer(CLI::App& command, LabelChanges& changes) {
  const std::string name = "--focus-transfer", form = "[LABEL=]PRESET|FILE.json|none";
  command
      .add_option_function<std::vector<std::string>>(
          name,
          [=, &changes](const std::vector<std::string>& texts) {
            changes.functions.clear();
            for (const std::string& text : texts) {
              const auto function = functionIn(text);
              if (!function) throw CLI::ValidationError(name, "\"" + text + "\" is not " + form);
              changes.functions.push_back(*function);
            }
          },
          "optical properties of the focus by value, as --transfer-function has those of all else: of one label, by "
          "value or name, or of all that is in focus. May be given several times. none: one colour and extinction")
      ->type_name(form)
      ->allow_extra_args(false);
}

void setFocusFunctions(const SceneOptions& options, Scene& scene) {
  Look& look = scene.look;
  for (const auto& [label, source] : options.labelChanges.functions) {
    std::optional<TransferFunction> function;
    if (!source.empty()) function = io::loadContextFunction(source, *scene.volume).function;
    std::vector<std::uint16_t> labels;
    if (!label.empty()) {
      if (!scene.labels)
        throw io::Error(labelFile(options), "has no label \"" + label + "\"", "name a label map with --labels");
      labels = resolveLabels(*scene.labels, {label}, labelFile(options));
    } else if (const auto* focus = std::get_if<LabelFocus>(&look.focus)) {
      labels = focus->labels;
    } else if (std::holds_alternative<std::monostate>(look.focus)) {
      throw io::Error(options.source(), "has no focus to show by value", "name one, as with --focus-range");
    } else {
      look.focusAppearance.function = function;
    }
    for (const std::uint16_t each : labels) {
      LabelSetting setting = settingFor(look.labels, each);
      setting.function = function;
      put(look.labels, setting);
    }
  }
}

void addLabelSettings(CLI::App& command, LabelChanges& changes) {
  addLabelList(command, "--hidden", "labels, by value or name, that 3-D pictures leave out", changes.hidden);
  addLabelList(command, "--protected", "labels, by value or name, that are never cut away, though they hide the focus",
               changes.guarded);
  addParsed(command, "--label-opacity", "LABEL=0..1,...",
            "opacity of labels, in focus or not: the share of what 10 mm of them have otherwise; 0 hides",
            [&changes](const std::string& text) { return readPairs(text, changes.opacities, shareIn); });
  addParsed(command, "--label-colour", "LABEL=#rrggbb,...", "colours of labels, in place of the label map's",
            [&changes](const std::string& text) { return readPairs(text, changes.colours, colourIn); });
  addParsed(command, "--importance-levels", "LABEL=0..4,...",
            "levels of importance of labels, by value or name, for the method importance: what hides a more important "
            "label is opened. Labels in focus have 4 by default, all else 0",
            [&changes](const std::string& text) { return readPairs(text, changes.importance, levelIn); });
}

void setLabelSettings(const SceneOptions& options, Scene& scene) {
  const LabelChanges& changes = options.labelChanges;
  if (changes.empty()) return;
  const fs::path file = labelFile(options);
  if (!scene.labels) throw io::Error(file, "has no labels to show in another way", "name a label map with --labels");
  const auto change = [&](const std::string& wanted, const auto& apply) {
    LabelSetting setting = settingFor(scene.look.labels, resolveLabels(*scene.labels, {wanted}, file).front());
    apply(setting);
    put(scene.look.labels, setting);
  };
  const auto setRole = [&](const std::vector<std::string>& labels, LabelRole role) {
    const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
    for (const std::string& wanted : labels)
      change(wanted, [&](LabelSetting& setting) {
        if (focus && std::binary_search(focus->labels.begin(), focus->labels.end(), setting.label))
          throw io::Error(file, "label \"" + wanted + "\" cannot be " + wordOf(role).word + ": it is in focus",
                          "name the labels of the focus with --focus-labels");
        setting.role = role;
      });
  };
  setRole(changes.hidden, LabelRole::Hidden);
  setRole(changes.guarded, LabelRole::Protected);
  if (!changes.importance.empty() && !std::holds_alternative<LabelFocus>(scene.look.focus))
    throw io::Error(file, "has no labels in focus, so --importance-levels has nothing to open",
                    "name the labels of the focus with --focus-labels");
  for (const auto& [label, level] : changes.importance)
    change(label, [value = level](LabelSetting& setting) { setting.importance = value; });
  for (const auto& [label, opacity] : changes.opacities)
    change(label, [value = opacity](LabelSetting& setting) { setting.opacity = value; });
  for (const auto& [label, colour] : changes.colours)
    change(label, [value = colour](LabelSetting& setting) { setting.colour = value; });
}

std::vector<std::uint16_t> resolveLabels(const LabelMap& labels, const std::vector<std::string>& wanted,
                                         const fs::path& file) {
  std::vector<std::uint16_t> values;
  for (const std::string& text : wanted) {
    const std::string name = io::lowered(text);
    const std::optional<std::uint16_t> number = parseNumber<std::uint16_t>(text);
    const auto at = std::find_if(labels.labels.begin(), labels.labels.end(), [&](const Label& label) {
      return number ? label.value == *number : io::lowered(label.name) == name;
    });
    if (at == labels.labels.end()) {
      const std::string nearest = nearestLabels(labels, text);
      throw io::Error(file, "there is no label \"" + text + "\"",
                      nearest.empty() ? "the label map is empty" : "the nearest are " + nearest);
    }
    values.push_back(at->value);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace fenestra::app
