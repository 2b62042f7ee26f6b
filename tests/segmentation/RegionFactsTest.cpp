#include "rendering/segmentation/RegionFacts.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::segmentation::regionFactsTest {
namespace {

/// The facts at a step in the middle of a growth whose volume grows by `factor` from step to step, with a strong edge.
RegionFacts factsOf(double factor, double compactness = 0.5, double contrast = 5.0, double shareOfBody = 0.001,
                    double mostRise = 6.0) {
  constexpr int step = 100;
  const Grid grid = tests::gridOf(glm::ivec3(4));
  const auto volume = tests::volumeOf<float>(grid, [](glm::ivec3 at) { return static_cast<double>(at.x); });
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
  return GrowthFacts(*volume, growth).at(growth, step);
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

}  // namespace
}  // namespace fenestra::segmentation::regionFactsTest
