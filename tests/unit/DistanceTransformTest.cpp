// Distances to a set of lattice points against a search through all of them.

#include "rendering/volume/DistanceTransform.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace fenestra::distanceTransformTest {
namespace {

/// mm to the nearest point of a set, by a search of all points.
double nearest(const std::vector<std::uint8_t>& set, const Grid& grid, glm::ivec3 from) {
  const glm::dmat3 worldFromIndex(grid.worldFromIndex());
  double least = std::numeric_limits<double>::infinity();
  for (int z = 0; z < grid.dims.z; ++z)
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x) {
        const glm::ivec3 index(x, y, z);
        if (set[grid.offset(index)]) least = std::min(least, glm::length(worldFromIndex * glm::dvec3(index - from)));
      }
  return least;
}

void expectExact(const std::vector<std::uint8_t>& set, const Grid& grid, const SampledLattice& at) {
  const std::vector<float> found = distancesTo(set, grid, at);
  ASSERT_EQ(found.size(), at.count());
  std::size_t i = 0;
  for (int z = 0; z < at.points.z; ++z)
    for (int y = 0; y < at.points.y; ++y)
      for (int x = 0; x < at.points.x; ++x) {
        const double expected = nearest(set, grid, at.first + at.step * glm::ivec3(x, y, z));
        // Three roundings to float32 of a square, and one of its root.
        ASSERT_NEAR(found[i], expected, 3e-7 * expected) << x << ", " << y << ", " << z;
        ++i;
      }
}

std::vector<std::uint8_t> randomSet(const Grid& grid, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution held(share);
  std::vector<std::uint8_t> set(grid.voxelCount());
  for (std::uint8_t& each : set) each = held(random) ? 1 : 0;
  set[set.size() / 3] = 1;
  return set;
}

Grid sheared(glm::ivec3 dims) {
  Grid grid{.dims = dims, .spacing = {0.7, 0.9, 2.5}};
  grid.direction[2] = glm::normalize(glm::dvec3(0.2, -0.5, 1.0));
  return grid;
}

TEST(DistanceTransform, IsTheDistanceToTheNearestPoint) {
  for (const double share : {0.002, 0.05, 0.6})
    for (const glm::ivec3 dims : {glm::ivec3(21, 17, 13), glm::ivec3(1, 30, 6), glm::ivec3(40, 1, 1)}) {
      SCOPED_TRACE(testing::Message() << share << ", " << dims.x);
      for (const Grid& grid : {Grid{.dims = dims, .spacing = {0.7, 0.9, 2.5}}, sheared(dims)})
        expectExact(randomSet(grid, share, 7), grid, {.points = dims});
    }
}

TEST(DistanceTransform, IsTakenAtAnyLattice) {
  const Grid straight{.dims = {12, 9, 7}, .spacing = {0.5, 1.5, 4.0}};
  for (const Grid& grid : {straight, sheared(straight.dims)})
    for (const SampledLattice& at :
         {SampledLattice{{-20, -3, -5}, {1, 1, 1}, {40, 16, 15}}, SampledLattice{{1, -4, 0}, {3, 2, 5}, {6, 9, 3}},
          SampledLattice{{50, 50, 50}, {1, 1, 1}, {2, 3, 1}}})
      expectExact(randomSet(grid, 0.03, 11), grid, at);
}

/// Thick slices of small voxels, tilted: beside a solid body a point inside it may be the nearest.
TEST(DistanceTransform, IsExactBesideASolidBodyInAShearedGrid) {
  Grid grid{.dims = {6, 24, 7}, .spacing = {0.5, 0.5, 5.0}};
  grid.direction[2] = glm::normalize(glm::dvec3(0.0, -0.4, 1.0));
  std::vector<std::uint8_t> set(grid.voxelCount());
  for (int z = 2; z < 5; ++z)
    for (int y = 8; y < 16; ++y)
      for (int x = 1; x < 5; ++x) set[grid.offset({x, y, z})] = 1;
  expectExact(set, grid, {.points = grid.dims});
}

/// What lies within reach has the very bits that it has without a limit.
TEST(DistanceTransform, EndsAtItsReach) {
  const glm::ivec3 dims(41, 23, 17);
  for (const Grid& grid : {Grid{.dims = dims, .spacing = {0.7, 0.9, 2.5}}, sheared(dims)})
    for (const double share : {0.0003, 0.01, 0.7})
      for (const double reach : {1.8, 6.0}) {
        SCOPED_TRACE(testing::Message() << share << ", " << reach);
        const std::vector<std::uint8_t> set = randomSet(grid, share, 5);
        for (const SampledLattice& at :
             {SampledLattice{.points = dims}, SampledLattice{{-3, 1, -1}, {2, 1, 3}, {20, 23, 7}}}) {
          const std::vector<float> whole = distancesTo(set, grid, at), near = distancesTo(set, grid, at, reach);
          ASSERT_EQ(near.size(), whole.size());
          for (std::size_t i = 0; i < whole.size(); ++i)
            if (whole[i] <= reach)
              ASSERT_EQ(near[i], whole[i]) << i;
            else
              ASSERT_TRUE(std::isinf(near[i])) << i;
        }
      }
}

TEST(DistanceTransform, OfNothingIsInfinite) {
  for (const Grid& grid : {Grid{.dims = {4, 5, 6}}, sheared({4, 5, 6})})
    for (const float each : distancesTo(std::vector<std::uint8_t>(120), grid, {.points = {3, 3, 3}}))
      ASSERT_TRUE(std::isinf(each));
  EXPECT_EQ(distancesTo({}, Grid{}, {.points = {2, 2, 2}}).size(), 8u);
}

TEST(DistanceTransform, OrientationsAsFilesRoundThemAreOrthogonal) {
  Grid grid{.dims = {4, 4, 4}};
  EXPECT_TRUE(isOrthogonal(grid));
  grid.direction[2] = glm::normalize(glm::dvec3(1e-5, 0.0, 1.0));
  EXPECT_TRUE(isOrthogonal(grid));
  grid.direction[2] = glm::normalize(glm::dvec3(0.01, 0.0, 1.0));
  EXPECT_FALSE(isOrthogonal(grid));
}

}  // namespace
}  // namespace fenestra::distanceTransformTest
