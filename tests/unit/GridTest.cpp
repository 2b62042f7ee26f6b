#include "rendering/volume/Grid.h"

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::gridTest {
namespace {

using namespace tests;

TEST(Grid, voxelCentresLieAtOriginPlusSteps) {
  const Grid grid = obliqueGrid({4, 5, 6});
  const glm::dvec3 world(grid.worldFromIndex() * glm::dvec4(2.0, 3.0, 1.0, 1.0));
  const glm::dvec3 expected = grid.origin + grid.direction[0] * (2.0 * grid.spacing.x) +
                              grid.direction[1] * (3.0 * grid.spacing.y) + grid.direction[2] * grid.spacing.z;
  EXPECT_NEAR(glm::distance(world, expected), 0.0, 1e-12);  // a few roundings of numbers below 100
}

TEST(Grid, worldAndIndexAreInverseOfEachOther) {
  Grid sheared = obliqueGrid({30, 20, 10});
  sheared.direction[2] = glm::normalize(sheared.direction[2] + 0.3 * sheared.direction[1]);
  for (const Grid& grid : {obliqueGrid({30, 20, 10}), sheared}) {
    const glm::dmat4 round = grid.indexFromWorld() * grid.worldFromIndex();
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row) EXPECT_NEAR(round[column][row], column == row ? 1.0 : 0.0, 1e-12);
  }
}

TEST(Grid, indexFromWorldKeepsTheVoxelMetresFromTheOrigin) {
  const Grid grid = gridOf({100, 100, 100}, {0.05, 0.05, 10.0}, {1e6, -1e6, 1e6});
  const glm::dvec3 world(grid.worldFromIndex() * glm::dvec4(37.25, 11.5, 73.0, 1.0));
  const glm::dvec3 index(grid.indexFromWorld() * glm::dvec4(world, 1.0));
  // Doubles at 1e6 mm are 1e-10 mm apart, 2e-9 of a 0.05 mm voxel; a few such roundings.
  EXPECT_NEAR(index.x, 37.25, 2e-8);
  EXPECT_NEAR(index.y, 11.5, 2e-8);
  EXPECT_NEAR(index.z, 73.0, 2e-8);
}

TEST(Grid, voxelVolumeOfAShearedGridIsTheDeterminant) {
  Grid grid = gridOf({2, 2, 2}, {1.0, 2.0, 3.0});
  EXPECT_DOUBLE_EQ(grid.voxelVolume(), 6.0);
  grid.direction[2] = {0.0, 0.6, 0.8};
  EXPECT_DOUBLE_EQ(grid.voxelVolume(), 6.0 * 0.8);
  grid.direction[0] = {-1.0, 0.0, 0.0};  // left-handed
  EXPECT_DOUBLE_EQ(grid.voxelVolume(), 6.0 * 0.8);
}

TEST(Grid, cornersAreVoxelExtentsAroundTheCentre) {
  const Grid grid = gridOf({1, 3, 5}, {2.0, 1.0, 1.0}, {10.0, 0.0, 0.0});
  glm::dvec3 low(infinity), high(-infinity);
  for (const glm::dvec3& corner : grid.corners()) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  EXPECT_EQ(low, glm::dvec3(9.0, -0.5, -0.5));
  EXPECT_EQ(high, glm::dvec3(11.0, 2.5, 4.5));
  EXPECT_EQ(grid.centre(), glm::dvec3(10.0, 1.0, 2.0));
  EXPECT_DOUBLE_EQ(grid.boundingRadius(), glm::length(glm::dvec3(1.0, 1.5, 2.5)));
}

TEST(Grid, offsetRunsXFastest) {
  const Grid grid = gridOf({3, 4, 5});
  std::size_t expected = 0;
  forEachVoxel(grid.dims, [&](glm::ivec3 index) {
    EXPECT_EQ(grid.offset(index), expected++);
    EXPECT_TRUE(grid.contains(index));
  });
  EXPECT_EQ(expected, grid.voxelCount());
  EXPECT_FALSE(grid.contains({3, 0, 0}));
  EXPECT_FALSE(grid.contains({0, -1, 0}));
}

}  // namespace
}  // namespace fenestra::gridTest
