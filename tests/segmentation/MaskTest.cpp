#include "rendering/segmentation/Mask.h"

#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::segmentation::maskTest {
namespace {

template <class InsideAt>
Mask maskOn(const Grid& grid, InsideAt insideAt) {
  Mask mask{grid, {}};
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) { mask.voxels.push_back(insideAt(at) ? 1 : 0); });
  return mask;
}

double distance(const Grid& grid, glm::ivec3 a, glm::ivec3 b) {
  return glm::length(glm::dvec3(grid.worldFromIndex() * glm::dvec4(glm::dvec3(a - b), 0.0)));
}

/// Grows and shrinks a random mask and compares every voxel with the definition.
void expectExactDistances(const Grid& grid, double reach) {
  std::mt19937 random(5);
  const Mask mask = maskOn(grid, [&](glm::ivec3) { return random() % 5 == 0; });
  const Mask larger = grown(mask, reach), smaller = shrunk(larger, reach);
  const VoxelBox whole = wholeOf(grid.dims);
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    bool near = false, farFromOutside = true;
    for (std::size_t j = 0; j < mask.voxels.size(); ++j) {
      if (distance(grid, whole.at(i), whole.at(j)) > reach + 1e-6) continue;
      near = near || mask.voxels[j];
      farFromOutside = farFromOutside && larger.voxels[j];
    }
    ASSERT_EQ(larger.voxels[i], near ? 1 : 0) << i;
    ASSERT_EQ(smaller.voxels[i], farFromOutside ? 1 : 0) << i;
  }
}

TEST(Mask, GrowsAndShrinksByDistanceInTheWorld) {
  expectExactDistances(tests::gridOf({9, 8, 7}), 1.5);
  expectExactDistances(tests::obliqueGrid({9, 8, 7}), 2.2);
  Grid tilted = tests::gridOf({9, 8, 7}, {1.0, 1.0, 1.0});
  tilted.direction[2] = glm::normalize(glm::dvec3(0.0, 0.6, 0.8));
  expectExactDistances(tilted, 1.9);
}

TEST(Mask, ByNoDistanceStays) {
  const Mask mask = maskOn(tests::gridOf(glm::ivec3(6)), [](glm::ivec3 at) { return at.x > 2; });
  EXPECT_EQ(grown(mask, 0.0).voxels, mask.voxels);
  EXPECT_EQ(shrunk(mask, 0.0).voxels, mask.voxels);
}

TEST(Mask, IsNotShrunkWhereTheVolumeCutsIt) {
  const Mask mask = maskOn(tests::gridOf(glm::ivec3(8)), [](glm::ivec3 at) { return at.x >= 4; });
  const Mask smaller = shrunk(mask, 1.0);
  tests::forEachVoxel(glm::ivec3(8),
                      [&](glm::ivec3 at) { EXPECT_EQ(smaller.voxels[mask.grid.offset(at)], at.x >= 5 ? 1 : 0); });
}

TEST(Mask, FillsHolesThatAreClosedOnAllSides) {
  const auto shell = [](glm::ivec3 at) {
    const double r = glm::distance(glm::dvec3(at), glm::dvec3(7.0));
    return r <= 6.0 && r >= 4.0;
  };
  const Grid grid = tests::gridOf(glm::ivec3(15));
  const Mask filled = withHolesFilled(maskOn(grid, shell));
  EXPECT_EQ(filled.voxels,
            maskOn(grid, [](glm::ivec3 at) { return glm::distance(glm::dvec3(at), glm::dvec3(7.0)) <= 6.0; }).voxels);
  // A channel to the outside opens it.
  const Mask open = maskOn(grid, [&](glm::ivec3 at) { return shell(at) && !(at.y == 7 && at.z == 7 && at.x > 7); });
  EXPECT_EQ(withHolesFilled(open).voxels, open.voxels);
}

TEST(Mask, LosesIslands) {
  const Grid grid = tests::gridOf({20, 9, 9}, glm::dvec3(2.0));
  const auto large = [](glm::ivec3 at) { return at.x < 5; };
  // Two voxels that touch at a corner are one part of 16 mm³; a third is alone.
  const auto small = [](glm::ivec3 at) { return at == glm::ivec3(10, 4, 4) || at == glm::ivec3(11, 5, 5); };
  const auto single = [](glm::ivec3 at) { return at == glm::ivec3(16, 2, 2); };
  const Mask mask = maskOn(grid, [&](glm::ivec3 at) { return large(at) || small(at) || single(at); });
  EXPECT_EQ(withoutIslands(mask, 16.0).voxels,
            maskOn(grid, [&](glm::ivec3 at) { return large(at) || small(at); }).voxels);
  EXPECT_EQ(withoutIslands(mask, 0.0).voxels, mask.voxels);
  EXPECT_EQ(largestPart(mask).voxels, maskOn(grid, large).voxels);
}

TEST(Mask, EmptyOnesStayEmpty) {
  const Mask mask = maskOn(tests::gridOf(glm::ivec3(4)), [](glm::ivec3) { return false; });
  EXPECT_TRUE(boundsOf(mask).empty());
  for (const Mask& each :
       {grown(mask, 2.0), shrunk(mask, 2.0), withHolesFilled(mask), withoutIslands(mask, 1.0), largestPart(mask)})
    EXPECT_EQ(each.voxels, mask.voxels);
}

TEST(Mask, FullOnesStayFull) {
  const Mask mask = maskOn(tests::gridOf(glm::ivec3(4)), [](glm::ivec3) { return true; });
  for (const Mask& each : {grown(mask, 2.0), shrunk(mask, 2.0), withHolesFilled(mask), largestPart(mask)})
    EXPECT_EQ(each.voxels, mask.voxels);
}

TEST(Mask, KnowsItsBoundsAndVolume) {
  const Grid grid = tests::gridOf({10, 11, 12}, {1.0, 2.0, 3.0});
  const VoxelBox box{{2, 3, 4}, {5, 9, 11}};
  const Mask mask = maskOn(grid, [&](glm::ivec3 at) { return box.contains(at); });
  EXPECT_EQ(boundsOf(mask), box);
  EXPECT_DOUBLE_EQ(volumeOf(mask), 3.0 * 6.0 * 7.0 * 6.0);
}

TEST(Mask, BecomesALabelAndComesBack) {
  const Grid grid = tests::gridOf({5, 4, 3});
  const Mask mask = maskOn(grid, [](glm::ivec3 at) { return (at.x + at.y) % 2; });
  for (const std::uint16_t value : {7, 700}) {
    const auto labels = labelMapOf(mask, {value, "kept", glm::dvec3(0.5)});
    EXPECT_EQ(maskOf(*labels, value).voxels, mask.voxels);
    ASSERT_NE(labels->find(value), nullptr);
    EXPECT_EQ(labels->find(value)->name, "kept");
  }
}

}  // namespace
}  // namespace fenestra::segmentation::maskTest
