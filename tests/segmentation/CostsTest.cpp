#include "rendering/segmentation/Costs.h"

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::segmentation::costsTest {
namespace {

constexpr Noise unitNoise{0.0, 1.0};  ///< edges count from 0.5 units on

/// Levels along x of a volume that changes along x alone.
std::vector<Level> levelsAlong(const std::vector<double>& values, float seed) {
  const glm::ivec3 dims(static_cast<int>(values.size()), 3, 3);
  const auto volume = tests::volumeOf<float>(tests::gridOf(dims),
                                             [&](glm::ivec3 at) { return values[static_cast<std::size_t>(at.x)]; });
  const ToneScale scale(*volume, unitNoise, 0.0);
  EdgeSharpener sharpener(*volume, scale);
  sharpener.read(wholeOf(dims));
  std::vector<Level> levels;
  sharpener.forRows(TissueCost(std::array{seed}), [&](int, int, std::span<const Level> row) {
    if (levels.empty()) levels.assign(row.begin(), row.end());
    EXPECT_TRUE(std::equal(row.begin(), row.end(), levels.begin())) << "all rows are alike";
  });
  return levels;
}

/// Smoothing leaves a thousandth of an edge, which is a level or two.
void expectNear(const std::vector<Level>& levels, const std::vector<int>& expected) {
  ASSERT_EQ(levels.size(), expected.size());
  for (std::size_t i = 0; i < levels.size(); ++i) EXPECT_NEAR(levels[i], expected[i], 2) << "at " << i;
}

TEST(TissueCost, CountsBrighterValuesHalf) {
  const TissueCost cost(std::array{2.0f, 5.0f});
  EXPECT_FLOAT_EQ(cost(-1.0f), 3.0f);
  EXPECT_FLOAT_EQ(cost(3.0f), 0.0f) << "between the seeds";
  EXPECT_FLOAT_EQ(cost(9.0f), 2.0f);
  EXPECT_EQ(cost.levelOf(3.0f), levelOf(3.0));
  EXPECT_EQ(cost.levelOf(1000.0f), never);
}

TEST(EdgeSharpener, GivesAVoxelOnAnEdgeTheTissueItHoldsMoreOf) {
  const Level far = levelOf(10.0);
  expectNear(levelsAlong({0, 0, 0, -4, -10, -10, -10}, 0.0f), {0, 0, 0, 0, far, far, far});
  expectNear(levelsAlong({0, 0, 0, -6, -10, -10, -10}, 0.0f), {0, 0, 0, far, far, far, far});
}

TEST(EdgeSharpener, KeepsALayerOfOneVoxelAndALowEdge) {
  const Level wall = levelOf(6.0);
  expectNear(levelsAlong({0, 0, 0, -6, 0, 0, 0}, 0.0f), {0, 0, 0, wall, 0, 0, 0});
  const std::vector<Level> low = levelsAlong({0, 0, 0, -0.2, -0.4, -0.4, -0.4}, 0.0f);
  EXPECT_GT(low[3], low[2]);
  EXPECT_LT(low[3], low[4]);
}

TEST(EdgeSharpener, HalvesValuesNotTones) {
  // A lung beside muscle: beyond the display window tones are compressed, and their middle is no half.
  const std::vector<double> values{-900, -900, -900, -500, 0, 0, 0};
  const auto volume = tests::volumeOf<std::int16_t>(tests::gridOf({7, 3, 3}), [&](glm::ivec3 at) {
    if (at == glm::ivec3(0)) return -1024.0;
    if (at == glm::ivec3(6, 2, 2)) return 1500.0;
    return values[static_cast<std::size_t>(at.x)];
  });
  ASSERT_TRUE(volume->isInHounsfieldUnits());
  const ToneScale scale(*volume, {1.0, 10.0}, -900.0);
  EdgeSharpener sharpener(*volume, scale);
  sharpener.read({{2, 1, 1}, {5, 2, 2}});
  sharpener.forRows(TissueCost(std::array{0.0f}), [&](int, int, std::span<const Level> row) {
    EXPECT_LT(costOf(row[0]), 1.0);
    EXPECT_EQ(row[1], row[0]) << "-500 is nearer to -900 than to 0";
    EXPECT_GT(costOf(row[2]), 10.0);
  });
}

}  // namespace
}  // namespace fenestra::segmentation::costsTest
