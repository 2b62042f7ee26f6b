#include "rendering/scene/Importance.h"

#include <algorithm>
#include <array>

namespace fenestra {
namespace {

bool isIn(const std::vector<std::uint16_t>& labels, std::uint16_t label) {
  return std::binary_search(labels.begin(), labels.end(), label);
}

/// The labels in focus, where levels of importance count.
const LabelFocus* levelledFocus(const Scene& scene) {
  const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
  const bool counts = focus && scene.labels && focusesStructures(scene) && hasCutaway(scene);
  return counts && stagesOf(scene.look.method).hasLevels ? focus : nullptr;
}

}  // namespace

int importanceOf(const Scene& scene, std::uint16_t label) {
  const LabelSetting setting = settingFor(scene.look.labels, label);
  const auto* focus = focusesStructures(scene) ? std::get_if<LabelFocus>(&scene.look.focus) : nullptr;
  if (focus && isIn(focus->labels, label)) return setting.importance.value_or(mostImportant);
  return setting.visible && isInContext(scene, setting) ? setting.importance.value_or(0) : 0;
}

std::vector<std::vector<std::uint16_t>> importanceLevels(const Scene& scene) {
  const LabelFocus* focus = levelledFocus(scene);
  if (!focus) return {};
  std::vector<std::uint16_t> labels = focus->labels;
  for (const LabelSetting& each : scene.look.labels)
    if (each.importance && !isIn(focus->labels, each.label)) labels.push_back(each.label);
  std::sort(labels.begin(), labels.end());
  std::array<std::vector<std::uint16_t>, mostImportant + 1> ofLevelOrMore;
  for (const std::uint16_t label : labels)
    for (int level = std::clamp(importanceOf(scene, label), 0, mostImportant); level > 0; --level)
      ofLevelOrMore[static_cast<std::size_t>(level)].push_back(label);
  // A level that no label has is left out: its set is that of the next higher one.
  std::vector<std::vector<std::uint16_t>> levels;
  for (std::size_t level = 1; level < ofLevelOrMore.size(); ++level)
    if (!ofLevelOrMore[level].empty() && (levels.empty() || levels.back() != ofLevelOrMore[level]))
      levels.push_back(std::move(ofLevelOrMore[level]));
  if (levels.empty()) return {{}};
  if (levels.size() == 1 && levels.front() == focus->labels) return {};
  return levels;
}

}  // namespace fenestra
