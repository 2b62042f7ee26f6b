#include "rendering/scene/FaintLabels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fenestra {
namespace {

std::vector<double> distinct(const LabelSettings& settings) {
  std::vector<double> opacities;
  for (const LabelSetting& each : settings) opacities.push_back(each.opacity);
  std::sort(opacities.begin(), opacities.end());
  opacities.erase(std::unique(opacities.begin(), opacities.end()), opacities.end());
  return opacities;
}

}  // namespace

std::vector<std::uint8_t> FaintLabels::numberOfLabel() const {
  std::vector<std::uint8_t> all(std::numeric_limits<std::uint16_t>::max() + 1, 0);
  for (const auto& [label, number] : numbers) all[label] = number;
  return all;
}

FaintLabels faintLabels(const Scene& scene) {
  LabelSettings settings;
  for (const LabelSetting& each : scene.look.labels)
    if (each.opacity < 1.0 && isInContext(scene, each)) settings.push_back(each);
  FaintLabels faint;
  if (settings.size() <= FaintLabels::most) {
    for (const LabelSetting& each : settings) {
      faint.opacities.push_back(each.opacity);
      faint.numbers.emplace_back(each.label, static_cast<std::uint8_t>(faint.opacities.size()));
    }
    return faint;
  }
  faint.opacities = distinct(settings);
  if (faint.opacities.size() > FaintLabels::most) {
    constexpr double steps = FaintLabels::most + 1.0;
    for (LabelSetting& each : settings)
      each.opacity = std::clamp(std::round(each.opacity * steps), 1.0, steps - 1.0) / steps;
    faint.opacities = distinct(settings);
  }
  for (const LabelSetting& each : settings) {
    const auto at = std::lower_bound(faint.opacities.begin(), faint.opacities.end(), each.opacity);
    faint.numbers.emplace_back(each.label, static_cast<std::uint8_t>(1 + (at - faint.opacities.begin())));
  }
  return faint;
}

bool hasBodies(const Scene& scene) {
  const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
  const bool inFocus = focus && focusesStructures(scene) &&
                       std::any_of(scene.look.labels.begin(), scene.look.labels.end(), [&](const LabelSetting& each) {
                         return (each.opacity < 1.0 || !each.visible) &&
                                std::binary_search(focus->labels.begin(), focus->labels.end(), each.label);
                       });
  return inFocus || faintLabels(scene).any();
}

std::vector<TransferFunction> contextFunctions(const Scene& scene, const FaintLabels& faint) {
  std::vector<TransferFunction> functions{scene.look.context.shifted()};
  for (const double opacity : faint.opacities) functions.push_back(atOpacity(functions.front(), opacity));
  return functions;
}

}  // namespace fenestra
