#include "rendering/segmentation/Flood.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::segmentation::floodTest {
namespace {

template <class CostAt>
PaddedLevels levelsOf(glm::ivec3 dims, CostAt costAt) {
  PaddedLevels levels(dims);
  tests::forEachVoxel(dims, [&](glm::ivec3 at) { levels.all()[levels.offset(at)] = static_cast<Level>(costAt(at)); });
  return levels;
}

bool always(double) { return true; }

/// Minimax path costs by relaxation until nothing changes.
std::vector<int> relaxed(const PaddedLevels& costs, glm::ivec3 seed) {
  const VoxelBox box = wholeOf(costs.dims());
  std::vector<int> reached(box.count(), never);
  const auto costAt = [&](glm::ivec3 at) { return static_cast<int>(costs.all()[costs.offset(at)]); };
  reached[box.offset(seed)] = costAt(seed);
  for (bool changed = true; changed;) {
    changed = false;
    tests::forEachVoxel(costs.dims(), [&](glm::ivec3 at) {
      for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
          glm::ivec3 from = at;
          from[axis] += step;
          if (!box.contains(from)) continue;
          const int cost = std::max(reached[box.offset(from)], costAt(at));
          if (cost < reached[box.offset(at)]) {
            reached[box.offset(at)] = cost;
            changed = true;
          }
        }
    });
  }
  return reached;
}

TEST(Flood, FindsTheLeastOfTheGreatestCostsOnAllPaths) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 40; ++trial) {
    const glm::ivec3 dims(7, 5, 4), seed(3, 2, 1);
    // A quarter of the voxels bars the way. Few costs make long runs of one level.
    const std::uint32_t different = trial % 2 ? 255 : 3;
    const PaddedLevels costs =
        levelsOf(dims, [&](glm::ivec3) { return random() % 4 ? random() % different : std::uint32_t{never}; });
    if (costs.all()[costs.offset(seed)] == never) continue;
    const Flooded flooded = flood({&costs, {seed}}, {}, always);
    const std::vector<int> expected = relaxed(costs, seed);
    tests::forEachVoxel(dims, [&](glm::ivec3 at) {
      EXPECT_EQ(flooded.reached.all()[flooded.reached.offset(at)], expected[wholeOf(dims).offset(at)]);
    });
  }
}

TEST(Flood, KindsMeetAtTheRidgeBetweenThem) {
  const glm::ivec3 dims(21, 3, 3);
  const auto ridge = [](glm::ivec3 at) { return at.x == 12 ? 40 : 5; };
  const PaddedLevels costs = levelsOf(dims, ridge);
  const Flooded flooded = flood({&costs, {{1, 1, 1}}}, {&costs, {{19, 1, 1}}}, always);
  for (int x = 0; x < dims.x; ++x)
    if (x != 12) {
      EXPECT_EQ(flooded.outside[flooded.reached.offset({x, 1, 1})], x > 12) << x;
    }
}

TEST(Flood, WithoutARidgeTheNearerSeedWins) {
  const glm::ivec3 dims(20, 1, 1);
  const PaddedLevels costs = levelsOf(dims, [](glm::ivec3) { return 9; });
  const Flooded flooded = flood({&costs, {{0, 0, 0}}}, {&costs, {{19, 0, 0}}}, always);
  for (int x = 0; x < dims.x; ++x) EXPECT_EQ(flooded.outside[flooded.reached.offset({x, 0, 0})], x > 9) << x;
}

TEST(Flood, ACheaperKindTakesOver) {
  const glm::ivec3 dims(10, 1, 1);
  // For the inside everything is dear; for the outside the right part is cheap.
  const PaddedLevels dear = levelsOf(dims, [](glm::ivec3 at) { return at.x < 4 ? 3 : 90; });
  const PaddedLevels cheap = levelsOf(dims, [](glm::ivec3 at) { return at.x < 4 ? 90 : 3; });
  const Flooded flooded = flood({&dear, {{0, 0, 0}}}, {&cheap, {{9, 0, 0}}}, always);
  for (int x = 0; x < dims.x; ++x) {
    EXPECT_EQ(flooded.outside[flooded.reached.offset({x, 0, 0})], x >= 4) << x;
    EXPECT_EQ(flooded.reached.all()[flooded.reached.offset({x, 0, 0})], 3) << x;
  }
}

TEST(Flood, EndsWhenAskedTo) {
  const PaddedLevels costs = levelsOf({3, 3, 3}, [](glm::ivec3) { return 100; });
  int asked = 0;
  flood({&costs, {{1, 1, 1}}}, {}, [&](double) { return ++asked < 5; });
  EXPECT_EQ(asked, 5);
}

}  // namespace
}  // namespace fenestra::segmentation::floodTest
