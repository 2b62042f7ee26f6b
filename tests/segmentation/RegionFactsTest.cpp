#include "rendering/segmentation/RegionFacts.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::segmentation::regionFactsTest {
namespace {

constexpr int step = 100;

/// A growth whose volume grows by `factor` from step to step, with a strong edge; it begins with `step`.
Growth growthOf(double factor, double compactness = 0.5, double contrast = 5.0, double shareOfBody = 0.001,
                double mostRise = 6.0) {
  const Grid grid = tests::gridOf(glm::ivec3(4));
  Growth growth;
  const auto steps = std::make_shared<LabelMap>();
  steps->grid = grid;
  steps->voxels = Voxels(ScalarType::UInt8, grid.voxelCount());
  std::ranges::fill(steps->voxels.as<std::uint8_t>(), static_cast<std::uint8_t>(step));
  growth.steps = steps;
  growth.box = wholeOf(grid.dims);
  for (int each = 0; each <= stepCount; ++each)
    growth.curve.volume.push_back(each == 0 ? 0.0 : 1000.0 * std::pow(factor, each - step));
  growth.curve.contrast.assign(static_cast<std::size_t>(stepCount) + 1, contrast);
  growth.curve.compactness.assign(growth.curve.contrast.size(), compactness);
  growth.curve.plateaus = {{step, step, step, 1000.0, 5.0}};
  growth.curve.automatic = step;
  growth.curve.mostRise = mostRise;
  growth.bodyVolume = 1000.0 / shareOfBody;
  return growth;
}

RegionFacts factsAt(const Growth& growth, int at) {
  const auto volume =
      tests::volumeOf<float>(growth.steps->grid, [](glm::ivec3 voxel) { return static_cast<double>(voxel.x); });
  return GrowthFacts(*volume, growth).at(growth, at);
}

template <class... Numbers>
RegionFacts factsOf(Numbers... numbers) {
  return factsAt(growthOf(numbers...), step);
}

TEST(RegionFacts, ARegionThatOtherTolerancesHoldIsClear) {
  EXPECT_FALSE(factsOf(1.01).isPassing);
  EXPECT_EQ(factsOf(1.01).border, Border::Clear);
}

TEST(RegionFacts, AStageOfALeakIsDoubtfulHoweverStrongItsEdge) {
  EXPECT_TRUE(factsOf(1.6).isPassing);
  EXPECT_EQ(factsOf(1.6).border, Border::Doubtful);
}

TEST(RegionFacts, MuchOfTheBodyMustHoldForLonger) {
  // By half in 0.41 / 0.08 = 5 steps on each side, or in 0.41 / 0.02 = 20.
  EXPECT_EQ(factsOf(1.08).border, Border::Clear);
  EXPECT_EQ(factsOf(1.08, 0.5, 5.0, 0.05).border, Border::Doubtful);
  EXPECT_EQ(factsOf(1.02, 0.5, 5.0, 0.05).border, Border::Clear);
}

TEST(RegionFacts, ARaggedRegionNeedsAStrongerEdge) {
  EXPECT_EQ(factsOf(1.01, 0.5, 2.5).border, Border::Clear);
  EXPECT_EQ(factsOf(1.01, 0.2, 2.5).border, Border::Doubtful);
  EXPECT_EQ(factsOf(1.01, 0.2, 4.0).border, Border::Clear);
}

TEST(RegionFacts, InLoudNoiseHalfOfWhatCountsIsAStrongEdge) {
  EXPECT_EQ(factsOf(1.01, 0.5, 1.2).border, Border::Fair);
  EXPECT_EQ(factsOf(1.01, 0.5, 1.2, 0.001, 2.0).border, Border::Clear);
  EXPECT_EQ(factsOf(1.01, 0.5, 0.9, 0.001, 2.0).border, Border::Fair);
  EXPECT_EQ(factsOf(1.01, 0.2, 1.4, 0.001, 2.0).border, Border::Doubtful);
  EXPECT_EQ(factsOf(1.01, 0.2, 1.6, 0.001, 2.0).border, Border::Clear);
}

TEST(RegionFacts, ALargeRegionIsDoubtfulBesideOneThatIsNearlyAsClear) {
  const auto factsWith = [](double lead, double share) {
    Growth growth = growthOf(1.01, 0.5, 5.0, share);
    growth.curve.lead = lead;
    return factsAt(growth, step);
  };
  EXPECT_TRUE(factsWith(0.2, 0.05).isRivalled);
  EXPECT_EQ(factsWith(0.2, 0.05).border, Border::Doubtful);
  EXPECT_EQ(factsWith(0.6, 0.05).border, Border::Clear);
  EXPECT_EQ(factsWith(0.2, 0.01).border, Border::Clear) << "a small one is seldom a leak";
}

TEST(RegionFacts, ARegionThatSpreadsFromAThinPartIsDoubtful) {
  Growth growth = growthOf(1.01);
  growth.curve.sprawl = 4.0;
  EXPECT_EQ(factsAt(growth, step).border, Border::Clear);
  growth.curve.sprawl = 5.0;
  EXPECT_TRUE(factsAt(growth, step).sprawls);
  EXPECT_EQ(factsAt(growth, step).border, Border::Doubtful);
  EXPECT_FALSE(factsAt(growth, step + 1).sprawls) << "another tolerance is the user's own";
}

TEST(RegionFacts, ABoneIsDoubtfulWhereItsNeighboursWithItAreMuchClearer) {
  Growth growth = growthOf(1.01);
  growth.curve.boneLead = -0.5;
  EXPECT_EQ(factsAt(growth, step).border, Border::Clear);
  growth.curve.boneLead = -0.6;
  EXPECT_TRUE(factsAt(growth, step).isRivalled);
  EXPECT_EQ(factsAt(growth, step).border, Border::Doubtful);
  EXPECT_FALSE(factsAt(growth, step + 1).isRivalled) << "another tolerance is the user's own";
}

TEST(RegionFacts, AFlatTubeIsDoubtful) {
  Growth growth = growthOf(1.01);
  growth.curve.flatness = 1.4;
  EXPECT_EQ(factsAt(growth, step).border, Border::Clear);
  growth.curve.flatness = 1.6;
  EXPECT_TRUE(factsAt(growth, step).isFlat);
  EXPECT_EQ(factsAt(growth, step).border, Border::Doubtful);
  EXPECT_FALSE(factsAt(growth, step + 1).isFlat) << "another tolerance is the user's own";
}

}  // namespace
}  // namespace fenestra::segmentation::regionFactsTest
