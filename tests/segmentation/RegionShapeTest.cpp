#include "rendering/segmentation/RegionShape.h"

#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "rendering/segmentation/RegionGrowing.h"
#include "tests/support/Scenes.h"

namespace fenestra::segmentation::regionShapeTest {
namespace {

constexpr int step = 10;

RegionShape shapeIn(const Grid& grid, glm::ivec3 seed, const std::function<bool(glm::dvec3)>& holds) {
  std::vector<Level> joins;
  double volume = 0.0;
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) {
    const bool isHeld = holds(glm::dvec3(at) * grid.spacing);
    joins.push_back(isHeld ? Level{0} : never);
    volume += isHeld ? grid.voxelVolume() : 0.0;
  });
  return shapeOf(grid, joins, step, volume, seed);
}

/// mm: a ball with a radius of 20 around (30, 30, 30), and a rod with one of 6 from there on along x.
bool isRodWithBall(glm::dvec3 at) {
  const bool isInRod = at.x >= 30.0 && at.x < 90.0 && glm::length(glm::dvec2(at.y, at.z) - 30.0) < 6.0;
  return glm::length(at - 30.0) < 20.0 || isInRod;
}

TEST(RegionShape, ThickensBeyondAThinPartAlone) {
  const Grid grid = tests::gridOf({100, 60, 60});
  // 20 over 6 mm, within a cell of 1.4 mm or two; outside each, half a voxel's side is added.
  EXPECT_NEAR(shapeIn(grid, {80, 30, 30}, isRodWithBall).thickening, 20.0 / 6.0, 0.8);
  EXPECT_DOUBLE_EQ(shapeIn(grid, {30, 30, 30}, isRodWithBall).thickening, 1.0);
  EXPECT_DOUBLE_EQ(shapeIn(grid, {30, 45, 30}, isRodWithBall).thickening, 1.0) << "near the ball's surface";
}

TEST(RegionShape, IsThatOfTheBodyAndNotOfItsVoxels) {
  const RegionShape coarse = shapeIn(tests::gridOf({50, 30, 30}, glm::dvec3(2.0)), {40, 15, 15}, isRodWithBall);
  const RegionShape fine = shapeIn(tests::gridOf({200, 120, 60}, {0.5, 0.5, 1.0}), {160, 60, 30}, isRodWithBall);
  EXPECT_NEAR(fine.thickening, coarse.thickening, 0.8);
  EXPECT_NEAR(fine.compactness, coarse.compactness, 0.05);
}

TEST(RegionShape, EndsNowhereAtAFaceOfTheVolume) {
  // A plate whose faces are the volume's but for one: 12 mm thick there, as deep as it is.
  const auto isInPlate = [](glm::dvec3 at) { return at.x < 12.0; };
  const RegionShape shape = shapeIn(tests::gridOf(glm::ivec3(40)), {11, 20, 20}, isInPlate);
  EXPECT_DOUBLE_EQ(shape.thickening, 1.0);
  EXPECT_DOUBLE_EQ(shape.compactness, 1.0) << "one face of the plate counts";
}

TEST(RegionShape, OfNothingIsThatOfABall) {
  const RegionShape shape = shapeIn(tests::gridOf(glm::ivec3(5)), glm::ivec3(2), [](glm::dvec3) { return false; });
  EXPECT_DOUBLE_EQ(shape.thickening, 1.0);
  EXPECT_DOUBLE_EQ(shape.compactness, 1.0);
}

TEST(RegionShape, IsKnownOfAClickInCt) {
  const Grid grid = tests::gridOf({100, 60, 60});
  const auto volume =
      tests::volumeOf<float>(grid, [](glm::ivec3 at) { return isRodWithBall(glm::dvec3(at)) ? 60.0 : -100.0; });
  RegionFocus settings{{{30.0, 30.0, 30.0}}, {}, {}};
  settings.rule = RegionRule::Tissues;
  const auto curve = [&] { return growRegion(*volume, settings, wholeOf(grid.dims))->curve; };
  EXPECT_DOUBLE_EQ(curve().sprawl, 1.0) << "values without a unit";
  volume->modality = Modality::CT;
  volume->unit = "HU";
  const GrowthCurve inCt = curve();
  const auto compactness = shapeIn(grid, {30, 30, 30}, isRodWithBall).compactness;
  EXPECT_DOUBLE_EQ(inCt.sprawl, 1.0 / compactness);
  EXPECT_GT(inCt.lead, 0.0) << "no other region is as clear";
}

}  // namespace
}  // namespace fenestra::segmentation::regionShapeTest
