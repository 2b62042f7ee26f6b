#include "io/study/LookChanges.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <system_error>

#include "io/TransferFunctionFile.h"
#include "io/study/LabelNames.h"
#include "io/study/StudyRequest.h"

namespace fenestra::io {
namespace {

namespace fs = std::filesystem;

/// mm for people to read.
std::string tenths(double value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 1);
  return error == std::errc() ? std::string(text.data(), end) : "?";
}

}  // namespace

void setFocusFunctions(const StudyRequest& request, SetScene& scene) {
  Look& look = scene.look;
  for (const auto& [label, source] : request.labelChanges.functions) {
    std::optional<TransferFunction> function;
    if (!source.empty()) function = loadContextFunction(source, *scene.volume).function;
    std::vector<std::uint16_t> labels;
    if (!label.empty()) {
      if (!scene.labels) throw Error(request.labelSource(), "has no label \"" + label + "\"", WayOut::NameLabels);
      labels = resolveLabels(*scene.labels, {label}, request.labelSource());
    } else if (const auto* focus = std::get_if<LabelFocus>(&look.focus)) {
      labels = focus->labels;
    } else if (std::holds_alternative<std::monostate>(look.focus)) {
      throw Error(request.source(), "has no focus to show by value", WayOut::NameFocus);
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

void setLabelSettings(const StudyRequest& request, SetScene& scene) {
  const LabelChanges& changes = request.labelChanges;
  if (changes.empty()) return;
  const fs::path file = request.labelSource();
  if (!scene.labels) throw Error(file, "has no labels to show in another way", WayOut::NameLabels);
  const auto change = [&](const std::string& wanted, const auto& apply) {
    LabelSetting setting = settingFor(scene.look.labels, resolveLabels(*scene.labels, {wanted}, file).front());
    apply(setting);
    put(scene.look.labels, setting);
  };
  const auto setRole = [&](const std::vector<std::string>& labels, LabelRole role, const char* word) {
    const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
    for (const std::string& wanted : labels)
      change(wanted, [&](LabelSetting& setting) {
        if (focus && std::binary_search(focus->labels.begin(), focus->labels.end(), setting.label))
          throw Error(file, "label \"" + wanted + "\" cannot be " + word + ": it is in focus", WayOut::NameFocusLabels);
        setting.role = role;
      });
  };
  setRole(changes.hidden, LabelRole::Hidden, "hidden");
  setRole(changes.guarded, LabelRole::Protected, "protected");
  if (!changes.importance.empty() && !std::holds_alternative<LabelFocus>(scene.look.focus))
    throw Error(file, "has no labels in focus, so levels of importance have nothing to open", WayOut::NameFocusLabels);
  for (const auto& [label, level] : changes.importance)
    change(label, [value = level](LabelSetting& setting) { setting.importance = value; });
  for (const auto& [label, opacity] : changes.opacities)
    change(label, [value = opacity](LabelSetting& setting) { setting.opacity = value; });
  for (const auto& [label, colour] : changes.colours)
    change(label, [value = colour](LabelSetting& setting) { setting.colour = value; });
}

void setClipping(const StudyRequest& request, SetScene& scene) {
  const ClipChanges& changes = request.clipChanges;
  Clipping& clipping = scene.look.clipping;
  const CropFrame frame(scene.volume->grid);
  if (changes.crop) {
    clipping.cropped = true;
    for (int axis = 0; axis < 3; ++axis) {
      const auto& [low, high] = (*changes.crop)[static_cast<std::size_t>(axis)];
      clipping.box.low[axis] = low.value_or(frame.low[axis]);
      clipping.box.high[axis] = high.value_or(frame.high[axis]);
      if (!(std::max(clipping.box.low[axis], frame.low[axis]) < std::min(clipping.box.high[axis], frame.high[axis])))
        throw Error(request.source(), std::string("has nothing inside the crop box along ") + "LPS"[axis],
                    "it reaches from " + tenths(frame.low[axis]) + " to " + tenths(frame.high[axis]) + " mm there");
    }
  }
  if (!changes.exempt.empty()) {
    const fs::path file = request.labelSource();
    if (!scene.labels) throw Error(file, "has no labels to exempt from clipping", WayOut::NameLabels);
    clipping.exempt = resolveLabels(*scene.labels, changes.exempt, file);
  }
}

}  // namespace fenestra::io
