// Which labels are translucent, and by what opacity.

#include "rendering/scene/FaintLabels.h"

#include <gtest/gtest.h>

#include "rendering/scene/SeenPoint.h"
#include "tests/support/Scenes.h"

namespace fenestra::faintLabelsTest {
namespace {

using namespace tests;
using Labels = std::vector<std::uint16_t>;
using Numbers = std::vector<std::pair<std::uint16_t, std::uint8_t>>;

/// Labels by x over an even medium.
Scene labelled() {
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(gridOf({30, 5, 5}), [](glm::ivec3) { return 100; });
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) { return i.x; });
  scene.look.context.function = {{{0.0, {glm::dvec3(1.0), 0.0}}, {200.0, {glm::dvec3(1.0), 0.4}}}};
  return scene;
}

TEST(FaintLabels, AreThoseOfTheContextBelowOpacity1) {
  Scene scene = labelled();
  put(scene.look.labels, {.label = 2, .opacity = 0.6});
  put(scene.look.labels, {.label = 3, .role = LabelRole::Protected, .opacity = 0.3});
  put(scene.look.labels, {.label = 4, .role = LabelRole::Hidden, .opacity = 0.3});
  put(scene.look.labels, {.label = 5, .opacity = 0.0});
  put(scene.look.labels, {.label = 6, .role = LabelRole::Protected, .opacity = 0.0});
  put(scene.look.labels, {.label = 7, .visible = false, .opacity = 0.6});
  put(scene.look.labels, {.label = 8, .role = LabelRole::Protected});
  put(scene.look.labels, {.label = 9, .opacity = 0.5});
  scene.look.focus = LabelFocus{{1, 9}};
  const FaintLabels faint = faintLabels(scene);
  EXPECT_EQ(faint.opacities, (std::vector<double>{0.6, 0.3, 0.6})) << "each label's own";
  EXPECT_EQ(faint.numbers, (Numbers{{2, 1}, {3, 2}, {7, 3}}));
  EXPECT_EQ(faint.opacityOf(0), 1.0);
  EXPECT_EQ(faint.opacityOf(2), 0.3);
  const std::vector<std::uint8_t> numbers = faint.numberOfLabel();
  ASSERT_EQ(numbers.size(), 65536u);
  EXPECT_EQ(numbers[2], 1);
  EXPECT_EQ(numbers[9], 0) << "in focus";
  EXPECT_EQ(labelsWith(LabelRole::Hidden, scene), (Labels{4, 5, 6})) << "opacity 0 is hidden";
  EXPECT_EQ(labelsWith(LabelRole::Protected, scene), (Labels{3, 8}));
  EXPECT_EQ(shownVolume(scene).hidden, (Labels{4, 5, 6}));

  const std::vector<TransferFunction> functions = contextFunctions(scene, faint);
  ASSERT_EQ(functions.size(), 4u);
  EXPECT_EQ(functions[0], scene.look.context.shifted());
  EXPECT_EQ(functions[2].nodes[1].properties.extinction, opticalExtinction(0.4, 0.3));
  EXPECT_EQ(functions[1].nodes[0].properties.extinction, 0.0);
  EXPECT_EQ(functions[1].evaluate(100.0).extinction, 0.5 * opticalExtinction(0.4, 0.6)) << "linear between nodes";

  scene.look.focus = ValueFocus{};
  EXPECT_EQ(faintLabels(scene).numbers.size(), 4u) << "no label is in focus";
  scene.structures = std::exchange(scene.labels, nullptr);
  EXPECT_EQ(faintLabels(scene).numbers.size(), 4u) << "beside a region";
  scene.structures = nullptr;
  EXPECT_FALSE(faintLabels(scene).any());
}

TEST(FaintLabels, OfTheFocusAreThoseBelowOpacity1) {
  Scene scene = labelled();
  scene.look.focus = LabelFocus{{1, 2}};
  EXPECT_FALSE(hasBodies(scene));
  EXPECT_EQ(drawnInFocus(scene, 1).opacity, 1.0);
  put(scene.look.labels, {.label = 2, .opacity = 0.25});
  EXPECT_TRUE(hasBodies(scene));
  EXPECT_EQ(drawnInFocus(scene, 2).opacity, 0.25);
  EXPECT_EQ(drawnInFocus(scene, 2).material.extinction, scene.look.focusAppearance.extinction) << "whole";
  put(scene.look.labels, {.label = 2, .visible = false});
  EXPECT_TRUE(hasBodies(scene));
  EXPECT_EQ(drawnInFocus(scene, 2).opacity, 0.0);
}

TEST(FaintLabels, AreOfAtMost127Opacities) {
  Scene scene = labelled();
  for (int label = 1; label <= 127; ++label)
    put(scene.look.labels, {.label = static_cast<std::uint16_t>(label), .opacity = label / 300.0});
  EXPECT_EQ(faintLabels(scene).opacities[4], 5 / 300.0) << "all as they are";
  put(scene.look.labels, {.label = 200, .opacity = 1e-9});
  put(scene.look.labels, {.label = 201, .opacity = 1.0 - 1e-9});
  const FaintLabels faint = faintLabels(scene);
  EXPECT_LE(faint.opacities.size(), FaintLabels::most);
  EXPECT_EQ(faint.numbers.size(), 129u);
  for (const auto& [label, number] : faint.numbers)
    EXPECT_NEAR(faint.opacities.at(number - 1u), settingFor(scene.look.labels, label).opacity, 1.0 / 128.0);
}

TEST(FaintLabels, AreNotWhatAClickMeansWhereMoreShowsBehindThem) {
  Scene scene = labelled();
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) { return i.x >= 5 && i.x < 15 ? 1 : 0; });
  scene.volume = volumeOf<std::int16_t>(scene.volume->grid,
                                        [](glm::ivec3 i) { return (i.x >= 5 && i.x < 15) || i.x >= 20 ? 100 : 0; });
  const auto seenAt = [&] { return seenPoint(scene, {-5.0, 2.0, 2.0}, {1.0, 0.0, 0.0})->x; };
  EXPECT_LT(seenAt(), 8.0);
  put(scene.look.labels, {.label = 1, .opacity = 0.1});
  EXPECT_GT(seenAt(), 18.0);
}

}  // namespace
}  // namespace fenestra::faintLabelsTest
