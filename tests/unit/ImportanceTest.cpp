// Levels of importance: which labels have which, and which levels a picture has.

#include <gtest/gtest.h>

#include "rendering/scene/Importance.h"
#include "tests/support/Scenes.h"

namespace fenestra::importanceTest {
namespace {

using namespace tests;
using Levels = std::vector<std::vector<std::uint16_t>>;

Scene withFocus(std::vector<std::uint16_t> labels) {
  Scene scene = labelScene(gridOf({4, 4, 4}), [](glm::ivec3 i) { return 1 + i.x; });
  scene.look.focus = LabelFocus{std::move(labels)};
  scene.look.method.kind = kindOf<methods::Importance>;
  return scene;
}

void setLevel(Scene& scene, std::uint16_t label, int level) {
  LabelSetting setting = settingFor(scene.look.labels, label);
  setting.importance = level;
  put(scene.look.labels, setting);
}

TEST(Importance, TheFocusAloneHasTheHighestLevelByDefault) {
  const Scene scene = withFocus({2, 3});
  EXPECT_EQ(importanceOf(scene, 1), 0);
  EXPECT_EQ(importanceOf(scene, 2), mostImportant);
  EXPECT_EQ(importanceOf(scene, 9), 0) << "of no voxel";
  EXPECT_EQ(importanceLevels(scene), Levels());
}

TEST(Importance, LevelsHoldAllLabelsOfTheirsOrMore) {
  Scene scene = withFocus({2, 3});
  setLevel(scene, 1, 1);
  EXPECT_EQ(importanceLevels(scene), (Levels{{1, 2, 3}, {2, 3}}));
  setLevel(scene, 3, 2);
  EXPECT_EQ(importanceLevels(scene), (Levels{{1, 2, 3}, {2, 3}, {2}}));
  setLevel(scene, 3, 0);
  EXPECT_EQ(importanceLevels(scene), (Levels{{1, 2}, {2}})) << "a label in focus that gives way to all others";
  setLevel(scene, 4, 4);
  EXPECT_EQ(importanceLevels(scene), (Levels{{1, 2, 4}, {2, 4}}));
}

TEST(Importance, TheSameLevelForAllOfTheFocusIsTheFocusAlone) {
  Scene scene = withFocus({2, 3});
  for (const std::uint16_t label : {2, 3}) setLevel(scene, label, 1);
  EXPECT_EQ(importanceLevels(scene), Levels());
  for (const std::uint16_t label : {2, 3}) setLevel(scene, label, 0);
  EXPECT_EQ(importanceLevels(scene), (Levels{{}})) << "nothing is important";
}

TEST(Importance, WhatIsNotShownHasNone) {
  for (const LabelSetting& setting : {LabelSetting{.label = 1, .role = LabelRole::Hidden, .importance = 3},
                                      LabelSetting{.label = 1, .visible = false, .importance = 3},
                                      LabelSetting{.label = 1, .opacity = 0.0, .importance = 3}}) {
    Scene scene = withFocus({2});
    put(scene.look.labels, setting);
    EXPECT_EQ(importanceOf(scene, 1), 0);
    EXPECT_EQ(importanceLevels(scene), Levels());
  }
}

TEST(Importance, CountsForAnOpeningOfLabelsByImportanceAlone) {
  Scene scene = withFocus({2});
  setLevel(scene, 1, 1);
  for (const ImportanceMode mode : {ImportanceMode::Maximum, ImportanceMode::Average}) {
    scene.look.method.of<methods::Importance>().mode = mode;
    EXPECT_EQ(importanceLevels(scene).size(), 2u);
  }
  Scene closed = scene, cone = scene, values = scene, region = scene;
  closed.look.cutaway.enabled = false;
  cone.look.method.kind = kindOf<methods::Cone>;
  values.look.focus = ValueFocus{{0.0, 1.0}, 0.0};
  region.structures = region.labels;
  region.labels = labelsOf(region.labels->grid, [](glm::ivec3 i) { return i.x; });
  for (const Scene& other : {closed, cone, values, region}) EXPECT_EQ(importanceLevels(other), Levels());
}

}  // namespace
}  // namespace fenestra::importanceTest
