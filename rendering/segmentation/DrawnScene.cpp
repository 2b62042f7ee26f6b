#include "rendering/segmentation/DrawnScene.h"

#include <utility>

#include "rendering/segmentation/RegionGrowing.h"

namespace fenestra::segmentation {
namespace {

/// The steps up to the region's own, as labels of Growth::steps.
Focus stepsInFocus(const RegionFocus& region, const Growth& growth) {
  LabelFocus steps;
  for (int step = 1; step <= growth.stepOf(region); ++step) steps.labels.push_back(static_cast<std::uint16_t>(step));
  return steps.labels.empty() ? Focus() : Focus(std::move(steps));
}

}  // namespace

void DrawnScene::update(const SetScene& set, const Growth* growth) {
  Scene whole = sceneOf(set);
  const auto* region = std::get_if<RegionFocus>(&set.look.focus);
  if (growth || !region) isRegion_ = region;
  if (region) {
    if (!set.labels) whole.look.labels.clear();
    whole.structures = set.labels;
    whole.labels = growth ? growth->steps : labels_;
    whole.look.focus = growth ? stepsInFocus(*region, *growth) : focus_;
  }
  labels_ = whole.labels;
  focus_ = whole.look.focus;
  scene_ = sculptor_.of(std::move(whole));
}

}  // namespace fenestra::segmentation
