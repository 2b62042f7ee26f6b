#include "rendering/segmentation/Curve.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::segmentation::curveTest {
namespace {

/// The curve of a volume whose voxels join at joinAt and cost the same.
template <class JoinAt>
GrowthCurve curveOf(const Grid& grid, JoinAt joinAt, const EdgeScale& edges = {}) {
  std::vector<Level> joins;
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) { joins.push_back(static_cast<Level>(joinAt(at))); });
  return growthCurve(joins, joins, grid, grid.dims, edges);
}

/// Greatest distance to the centre along an axis.
int shellOf(glm::ivec3 at, glm::ivec3 centre) {
  const glm::ivec3 d = glm::abs(at - centre);
  return std::max({d.x, d.y, d.z});
}

TEST(Curve, MeasuresABlock) {
  const Grid grid = tests::gridOf(glm::ivec3(21), {2.0, 3.0, 4.0});
  const GrowthCurve curve = curveOf(grid, [](glm::ivec3 at) { return shellOf(at, glm::ivec3(10)) <= 4 ? 10 : 100; });
  EXPECT_EQ(curve.volume[10], 0.0);
  const double volume = 729.0 * 24.0, area = 2.0 * (18.0 * 27.0 + 27.0 * 36.0 + 18.0 * 36.0);
  for (const std::size_t step : {11u, 50u, 100u}) {
    EXPECT_DOUBLE_EQ(curve.volume[step], volume);
    // A rise of costs counts up to six times the noise.
    EXPECT_NEAR(curve.contrast[step], std::min(6.0, costOf(100) - costOf(10)), 1e-9);
    EXPECT_NEAR(curve.compactness[step], std::cbrt(36.0 * std::numbers::pi * volume * volume) / area, 1e-9);
  }
  EXPECT_DOUBLE_EQ(curve.volume[101], 9261.0 * 24.0);
  EXPECT_EQ(curve.volume.size(), static_cast<std::size_t>(stepCount) + 1);
}

TEST(Curve, CountsNoMoreOfAnEdgeThanSoftTissuesDiffer) {
  const auto contrast = [](Modality modality, double noise) {
    Volume volume;
    volume.modality = modality;
    volume.range = {-1000.0, 1000.0};
    const auto block = [](glm::ivec3 at) { return shellOf(at, glm::ivec3(10)) <= 4 ? 10 : 200; };
    return curveOf(tests::gridOf(glm::ivec3(21)), block, competingEdges(volume, {noise, std::max(8.0, noise), 8.0}))
        .contrast[100];
  };
  EXPECT_NEAR(contrast(Modality::CT, 3.0), 6.0, 1e-9) << "units of the noise";
  EXPECT_NEAR(contrast(Modality::CT, 40.0), 2.0, 1e-9) << "80 HU";
  EXPECT_NEAR(contrast(Modality::MR, 40.0), 6.0, 1e-9) << "no unit tells what tissues differ by";
}

TEST(Curve, BeginsOnTheFirstPlateauBeforeALeak) {
  // A block at level 60; from 120 on a comb of rods; at 200 everything.
  const Grid grid = tests::gridOf(glm::ivec3(41));
  const GrowthCurve curve = curveOf(grid, [](glm::ivec3 at) {
    if (shellOf(at, glm::ivec3(20)) <= 6) return 60;
    return at.x % 2 && at.y % 2 ? 120 : 200;
  });
  ASSERT_FALSE(curve.plateaus.empty());
  EXPECT_EQ(curve.automatic, curve.plateaus.front().best);
  EXPECT_DOUBLE_EQ(curve.volume[static_cast<std::size_t>(curve.automatic)], 13.0 * 13.0 * 13.0);
  EXPECT_EQ(curve.plateaus.front().first, 61);
  EXPECT_EQ(curve.plateaus.front().last, 120);
}

TEST(Curve, BeginsBehindASpeckWhereAStructureFollows) {
  // A grain; a comb of rods around it, and the block that they lie in; such a comb in the rest, and all of it.
  const auto curve = [](double spacing, int block) {
    return curveOf(tests::gridOf(glm::ivec3(41), glm::dvec3(spacing)), [block](glm::ivec3 at) {
      const int shell = shellOf(at, glm::ivec3(20));
      if (shell <= 2) return 20;
      if (shell <= block) return at.x % 2 && at.y % 2 ? 100 : 140;
      return at.x % 2 && at.y % 2 ? 190 : 230;
    });
  };
  const auto volumeAt = [](const GrowthCurve& of) { return of.volume[static_cast<std::size_t>(of.automatic)]; };
  const GrowthCurve structure = curve(0.7, 7);
  ASSERT_GE(structure.plateaus.size(), 2u);
  EXPECT_NEAR(structure.plateaus.front().volume, 125.0 * 0.343, 1e-9) << "the grain is a plateau";
  EXPECT_NEAR(volumeAt(structure), 3375.0 * 0.343, 1e-9) << "and the block is begun with";
  // A grain this large counts as the structure that was meant.
  EXPECT_NEAR(volumeAt(curve(1.7, 7)), 125.0 * 4.913, 1e-9);
  // The next plateau fills more than half of the volume.
  EXPECT_NEAR(volumeAt(curve(0.7, 18)), 125.0 * 0.343, 1e-9);
}

TEST(Curve, OfNothingBeginsNowhere) {
  const GrowthCurve curve = curveOf(tests::gridOf(glm::ivec3(5)), [](glm::ivec3) { return never; });
  EXPECT_TRUE(curve.plateaus.empty());
  EXPECT_EQ(curve.automatic, 0);
}

TEST(Curve, OfAFewVoxelsBeginsWithThem) {
  const GrowthCurve curve =
      curveOf(tests::gridOf(glm::ivec3(5)), [](glm::ivec3 at) { return at == glm::ivec3(2) ? 30 : int{never}; });
  EXPECT_EQ(curve.automatic, 31);
}

/// A body of 1 l, with a region of `volumes` mm³ by the step at which they begin.
GrowthCurve madeCurve(const std::vector<std::pair<int, double>>& volumes, double contrast, double compactness) {
  GrowthCurve curve;
  for (int step = 0; step <= stepCount; ++step) {
    double volume = 0.0;
    for (const auto& [first, each] : volumes)
      if (step >= first) volume = each;
    curve.volume.push_back(volume);
    curve.contrast.push_back(volume > 0.0 ? contrast : 0.0);
    curve.compactness.push_back(volume > 0.0 ? compactness : 0.0);
  }
  return curve;
}

TEST(ClearestStep, IsTheRegionThatStaysLongest) {
  const StructurePrior prior = structurePrior(1e6, false);
  const Grid grid = tests::gridOf(glm::ivec3(100));
  const auto clearest = clearestStep(
      madeCurve({{10, 5000.0}, {20, 6000.0}, {60, 7000.0}, {70, 9000.0}, {80, 2e5}}, 3.0, 0.8), prior, grid);
  ASSERT_TRUE(clearest);
  EXPECT_EQ(clearest->step, 20);
}

TEST(ClearestStep, ComparesWithRegionsOfOtherSizes) {
  const StructurePrior prior = structurePrior(1e6, false);
  const Grid grid = tests::gridOf(glm::ivec3(100));
  // Each stays for 10 or 20 steps.
  const GrowthCurve curve = madeCurve({{10, 5000.0}, {30, 9000.0}, {40, 12000.0}, {60, 2e4}, {80, 7e5}}, 3.0, 0.8);
  EXPECT_DOUBLE_EQ(clarityBeside(curve, 9000.0, prior, grid), clarityAt(curve, 60, prior, grid))
      << "5 and 12 ml are as large as 9 by and large";
  EXPECT_DOUBLE_EQ(clarityBeside(curve, 2e4, prior, grid), clarityAt(curve, 10, prior, grid));
  EXPECT_DOUBLE_EQ(clarityBeyond(curve, 9000.0, prior, grid), clarityAt(curve, 60, prior, grid));
  EXPECT_EQ(clarityBeyond(curve, 2e4, prior, grid), -std::numeric_limits<double>::infinity()) << "5 ml are no larger";
  EXPECT_GT(clarityAt(curve, 10, prior, grid), clarityAt(curve, 30, prior, grid));
  EXPECT_EQ(clarityAt(curve, 80, prior, grid), -std::numeric_limits<double>::infinity()) << "no structure";
}

TEST(ClearestStep, LeavesOutWhatIsTooLargeOrHasNoBorder) {
  const Grid grid = tests::gridOf(glm::ivec3(100));
  StructurePrior prior = structurePrior(1e6, false);
  EXPECT_FALSE(clearestStep(madeCurve({{10, 7e5}}, 3.0, 0.8), prior, grid));
  EXPECT_TRUE(clearestStep(madeCurve({{10, 2e4}}, 3.0, 0.8), prior, grid));
  prior.contrast = 3.0;
  EXPECT_FALSE(clearestStep(madeCurve({{10, 2e4}}, 3.0, 0.8), prior, grid));
}

TEST(ClearestStep, ALargeRegionMustBeClearer) {
  const Grid grid = tests::gridOf(glm::ivec3(100));
  // 2e5 of 1e6 mm³ stays for 70 steps, 1e5 for 50: clearer by 0.3, and over 15 % of the body.
  const GrowthCurve curve = madeCurve({{10, 1e5}, {60, 2e5}, {130, 9e5}}, 3.0, 0.8);
  EXPECT_EQ(clearestStep(curve, structurePrior(1e6, false), grid)->step, 10);
  EXPECT_EQ(clearestStep(curve, structurePrior(1e6, true), grid)->step, 60);  // a lung may be as large
}

TEST(ClearestStep, MuchOfTheBodyMustBeClearerTheMoreItIs) {
  const Grid grid = tests::gridOf(glm::ivec3(100));
  // 1.2e5 of 1e6 mm³ stays for 70 steps, 4e4 for 50: clearer by 0.3, and 2.4 times a twentieth of the body.
  const GrowthCurve curve = madeCurve({{10, 4e4}, {60, 1.2e5}, {130, 9e5}}, 3.0, 0.8);
  EXPECT_EQ(clearestStep(curve, structurePrior(1e6, false), grid)->step, 10);
  EXPECT_EQ(clearestStep(curve, structurePrior(3e6, false), grid)->step, 60);  // less than a twentieth
  EXPECT_EQ(clearestStep(curve, structurePrior(1e6, true), grid)->step, 60);   // a lung may be as large
}

TEST(ClearestStep, WhatIsTooLargeForAStructureCostsNoMoreForItsSize) {
  const StructurePrior prior = structurePrior(1e6, false);
  EXPECT_EQ(costOfMuch(4e4, prior), 0.0);
  EXPECT_GT(costOfMuch(1.4e5, prior), costOfMuch(1e5, prior));
  EXPECT_EQ(costOfMuch(1.6e5, prior), 0.0) << "over 15 % of the body, and charged for that";
}

TEST(ClearestStep, ASmallerRegionOvercomesItsHandicap) {
  const Grid grid = tests::gridOf(glm::ivec3(100));
  StructurePrior prior = structurePrior(1e6, false);
  // 5e4 mm³ stays for 50 steps, 1e5 for 20.
  const GrowthCurve curve = madeCurve({{10, 5e4}, {60, 1e5}, {80, 9e5}}, 3.0, 0.8);
  const auto free = clearestStep(curve, prior, grid);
  ASSERT_EQ(free->step, 10);
  prior.smallerHandicap = 10.0;
  const auto handicapped = clearestStep(curve, prior, grid);
  EXPECT_EQ(handicapped->step, 60);
  EXPECT_EQ(handicapped->clarity, free->clarity);  // the clearest one's all the same
  prior.smallerHandicap = 0.01;
  EXPECT_EQ(clearestStep(curve, prior, grid)->step, 10);
}

TEST(ClearestStep, PrefersUsualSizes) {
  const Grid grid = tests::gridOf(glm::ivec3(100));
  StructurePrior prior = structurePrior(1e8, false);  // usual: 20 ml
  const GrowthCurve curve = madeCurve({{100, 2000.0}, {140, 25000.0}, {170, 90000.0}, {190, 5e7}}, 3.0, 0.8);
  EXPECT_EQ(clearestStep(curve, prior, grid)->step, 140);
  prior.expected = 25000.0;
  EXPECT_EQ(clearestStep(curve, prior, grid)->step, 140);
}

TEST(ClearestStep, LooksNoFurtherThanAsked) {
  const Grid grid = tests::gridOf(glm::ivec3(100));
  const StructurePrior prior = structurePrior(1e6, false);
  const GrowthCurve curve = madeCurve({{10, 1000.0}, {30, 2000.0}, {90, 2e5}}, 3.0, 0.8);
  EXPECT_EQ(clearestStep(curve, prior, grid)->step, 30);
  EXPECT_EQ(clearestStep(curve, prior, grid, 29)->step, 10);
  EXPECT_FALSE(clearestStep(curve, prior, grid, 9));
}

TEST(BeginWith, MakesAPlateauWhereThereIsNone) {
  GrowthCurve curve = madeCurve({{10, 1000.0}, {100, 3000.0}}, 3.0, 0.8);
  beginWith(curve, 120);
  EXPECT_EQ(curve.automatic, 120);
  ASSERT_EQ(curve.plateaus.size(), 1u);
  EXPECT_EQ(curve.plateaus.front().first, 100);
  beginWith(curve, 130);
  EXPECT_EQ(curve.plateaus.size(), 1u);  // holds it already
  beginWith(curve, 50);
  ASSERT_EQ(curve.plateaus.size(), 2u);
  EXPECT_EQ(curve.plateaus.front().best, 50);
}

}  // namespace
}  // namespace fenestra::segmentation::curveTest
