#include "rendering/segmentation/PickedStructure.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "rendering/segmentation/DrawnScene.h"
#include "rendering/segmentation/RegionGrowing.h"
#include "tests/support/Scenes.h"

namespace fenestra::segmentation::pickedStructureTest {
namespace {

using tests::gridOf;

/// A ball of 1000 around (20, 20, 20) in air of 0, on a grid of 40³ mm.
Scene ballInAir() {
  Scene scene;
  scene.volume = tests::volumeOf<std::int16_t>(
      gridOf(glm::ivec3(40)), [](glm::ivec3 index) { return glm::length(glm::dvec3(index) - 20.0) < 8.0 ? 1000 : 0; });
  return scene;
}

TEST(PickedStructure, WithoutLabelsARegionGrows) {
  const Scene scene = ballInAir();
  const PickedStructure picked = pickedStructure(scene, glm::dvec3(21.0));
  ASSERT_TRUE(picked.labels) << picked.problem;
  EXPECT_TRUE(picked.isGrown);
  EXPECT_FALSE(picked.label);
  const auto isMember = [&](glm::ivec3 index) {
    return std::binary_search(picked.values.begin(), picked.values.end(), picked.labels->value(index));
  };
  tests::forEachVoxel(scene.volume->grid.dims, [&](glm::ivec3 index) {
    const double radius = glm::length(glm::dvec3(index) - 20.0);
    const bool isBorder = radius > 7.0 && radius < 9.0;  // may go to either side
    EXPECT_TRUE(isBorder || isMember(index) == (radius < 8.0)) << radius;
  });
}

TEST(PickedStructure, ALabelIsTakenWhereThereIsOne) {
  Scene scene = ballInAir();
  scene.labels = tests::labelsOf(scene.volume->grid, [](glm::ivec3 index) { return index.z > 30 ? 7 : 0; });
  const PickedStructure labelled = pickedStructure(scene, {5.0, 5.0, 35.0});
  EXPECT_EQ(labelled.label, 7);
  EXPECT_EQ(labelled.labels, scene.labels);
  EXPECT_EQ(labelled.values, std::vector<std::uint16_t>{7});
  EXPECT_FALSE(labelled.isGrown);
  EXPECT_TRUE(pickedStructure(scene, glm::dvec3(20.0)).isGrown);  // without a label there
}

TEST(PickedStructure, TheRegionInFocusIsTakenWhereItHoldsThePoint) {
  Scene scene = ballInAir();
  const auto labels = tests::labelsOf(scene.volume->grid, [](glm::ivec3) { return 9; });
  scene.labels = labels;
  const RegionFocus region{{glm::dvec3(20.0)}, {}, {}};
  scene.look.focus = region;
  const auto growth = growRegion(*scene.volume, region, wholeOf(scene.volume->grid.dims));
  DrawnScene drawn;
  drawn.update({scene.volume, scene.labels, scene.look}, &*growth);
  const Scene& shown = drawn.scene();
  const PickedStructure inside = pickedStructure(shown, glm::dvec3(21.0));
  EXPECT_EQ(inside.labels, growth->steps);
  EXPECT_FALSE(inside.isGrown);
  EXPECT_EQ(inside.values.size(), static_cast<std::size_t>(growth->stepOf(region)));
  const PickedStructure outside = pickedStructure(shown, glm::dvec3(2.0));
  EXPECT_EQ(outside.label, 9);
  EXPECT_EQ(outside.labels, labels);
}

TEST(PickedStructure, ThereIsNoneInAirOrOutside) {
  Scene scene = ballInAir();
  EXPECT_FALSE(pickedStructure(scene, glm::dvec3(3.0)).labels);
  EXPECT_NE(pickedStructure(scene, glm::dvec3(3.0)).problem.find("air"), std::string::npos);
  for (const glm::dvec3 pick : {glm::dvec3(20.0, 20.0, 39.6), glm::dvec3(1e300), glm::dvec3(-1.0, 20.0, 20.0)}) {
    EXPECT_FALSE(pickedStructure(scene, pick).labels);
    EXPECT_NE(pickedStructure(scene, pick).problem.find("outside"), std::string::npos);
  }
  // In Hounsfield units lung is not air.
  auto lung = tests::volumeOf<std::int16_t>(gridOf(glm::ivec3(40)), [](glm::ivec3 index) {
    return glm::length(glm::dvec3(index) - 20.0) < 8.0 ? -850 : index.x > 35 ? 400 : -1000;
  });
  lung->unit = "HU";
  lung->modality = Modality::CT;
  ASSERT_TRUE(lung->isInHounsfieldUnits());
  scene.volume = lung;
  EXPECT_TRUE(pickedStructure(scene, glm::dvec3(20.0)).labels);
  EXPECT_FALSE(pickedStructure(scene, glm::dvec3(5.0)).labels);
  // A cancelled growth has no structure, and no problem either.
  const PickedStructure cancelled = pickedStructure(scene, glm::dvec3(20.0), [](double) { return false; });
  EXPECT_FALSE(cancelled.labels);
  EXPECT_TRUE(cancelled.problem.empty());
}

}  // namespace
}  // namespace fenestra::segmentation::pickedStructureTest
