#include "rendering/segmentation/Morphology.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::segmentation::morphologyTest {
namespace {

using tests::gridOf;
using tests::obliqueGrid;

TEST(Levels, GrowWithTheCostAndReturnIt) {
  for (int level = 0; level < levelCount; ++level) {
    EXPECT_EQ(levelOf(costOf(level)), level);
    if (level > 0) {
      EXPECT_GT(costOf(level), costOf(level - 1));
    }
  }
  EXPECT_EQ(levelOf(0.0), 0);
  EXPECT_EQ(levelOf(1e6), never);
}

TEST(Morphology, ABallHasTheVoxelsWithinItsRadius) {
  const Grid cubes = gridOf(glm::ivec3(9));
  EXPECT_EQ(ballOffsets(cubes, 0.0).size(), 1u);
  EXPECT_EQ(ballOffsets(cubes, 1.0).size(), 7u);
  EXPECT_EQ(ballOffsets(cubes, 1.5).size(), 19u);
  EXPECT_EQ(ballOffsets(cubes, 2.0).size(), 33u);
  // Slices 10 mm apart: a ball of 4 mm stays in its slice.
  for (const glm::ivec3 offset : ballOffsets(gridOf(glm::ivec3(9), {3.0, 3.0, 10.0}), 4.0)) EXPECT_EQ(offset.z, 0);
}

TEST(Morphology, ABallOnAShearedGridIsRoundInTheWorld) {
  Grid grid = gridOf(glm::ivec3(9), {0.8, 0.8, 2.0});
  grid.direction[2] = glm::normalize(glm::dvec3(0.0, 0.6, 1.0));  // a tilted gantry
  const double radius = 5.0;
  const std::vector<glm::ivec3> offsets = ballOffsets(grid, radius);
  const glm::dmat3 step(grid.direction[0] * 0.8, grid.direction[1] * 0.8, grid.direction[2] * 2.0);
  std::size_t expected = 0;
  for (int z = -20; z <= 20; ++z)
    for (int y = -20; y <= 20; ++y)
      for (int x = -20; x <= 20; ++x) expected += glm::length(step * glm::dvec3(x, y, z)) <= radius;
  EXPECT_EQ(offsets.size(), expected);
}

TEST(Morphology, GreatestAndLeastAreThoseOfTheBall) {
  const glm::ivec3 dims(9, 7, 6);
  const Grid grid = obliqueGrid(dims);
  const VoxelBox box = wholeOf(dims);
  std::mt19937 random(1);
  std::vector<Level> levels(box.count());
  for (Level& level : levels) level = static_cast<Level>(random() % 256);
  const std::vector<glm::ivec3> ball = ballOffsets(grid, 2.2);
  ASSERT_GT(ball.size(), 7u);
  const std::vector<Level> greatest = greatestWithin(levels, dims, ball);
  std::vector<Level> least(box.count(), 200);
  lowerToLeastWithin(levels, dims, ball, least);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    Level most = 0, fewest = 200;
    for (const glm::ivec3 offset : ball)
      if (box.contains(box.at(i) + offset)) {
        most = std::max(most, levels[box.offset(box.at(i) + offset)]);
        fewest = std::min(fewest, levels[box.offset(box.at(i) + offset)]);
      }
    EXPECT_EQ(greatest[i], most);
    EXPECT_EQ(least[i], fewest);
  }
}

}  // namespace
}  // namespace fenestra::segmentation::morphologyTest
