#include "rendering/segmentation/RegionCut.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "tests/segmentation/MadeRegions.h"

namespace fenestra::segmentation::regionCutTest {
namespace {

using tests::gridOf;
using tests::regionOf;
using tests::volumeOf;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int step = 5;

bool inBall(glm::ivec3 at, glm::dvec3 centre, double radius) { return glm::length(glm::dvec3(at) - centre) <= radius; }

/// Shares of the voxels that `isWanted` which are taken, and of the others.
struct Shares {
  double wanted = 0.0, others = 0.0;
};
template <class IsWanted>
Shares sharesOf(const std::vector<std::uint8_t>& taken, const std::vector<Level>& joins, const Grid& grid,
                IsWanted isWanted) {
  double counts[2] = {0.0, 0.0}, sums[2] = {0.0, 0.0};
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) {
    const std::size_t i = grid.offset(at), side = isWanted(at) ? 1 : 0;
    if (joins[i] >= step) {
      EXPECT_EQ(taken[i], 0);
      return;
    }
    ++counts[side];
    sums[side] += taken[i];
  });
  return {sums[1] / counts[1], sums[0] / counts[0]};
}

const glm::dvec3 left(16.0), right(40.0, 16.0, 16.0);
const Grid twoBalls = gridOf({57, 33, 33});
bool inLeft(glm::ivec3 at) { return inBall(at, left, 13.0) && at.x <= 28; }
bool inEither(glm::ivec3 at) { return inLeft(at) || inBall(at, right, 13.0); }
std::shared_ptr<Volume> evenVolume(const Grid& grid) {
  return volumeOf<float>(grid, [](glm::ivec3) { return 7.0; });
}

TEST(RegionCut, ASeedInTheMiddleOfAPartTakesThePart) {
  const auto volume = evenVolume(twoBalls);
  const std::vector<Level> joins = regionOf(twoBalls, inEither);
  const glm::ivec3 inside(left), outside(right);
  const auto taken = cutOff(*volume, joins, step, std::span(&inside, 1), std::span(&outside, 1),
                            {.perVolume = 0.03, .edge = infinity});
  const Shares shares = sharesOf(taken, joins, twoBalls, [](glm::ivec3 at) { return !inLeft(at); });
  EXPECT_GT(shares.wanted, 0.97);
  EXPECT_LT(shares.others, 0.03);
}

/// A ball that has leaked through a neck into a block, which is so large that its price exceeds that of any cut.
TEST(RegionCut, ASeedInALargeLeakTakesItUpToTheNeck) {
  const Grid grid = gridOf({120, 61, 61});
  const glm::dvec3 ball(15.0, 30.0, 30.0);
  const auto inLeak = [](glm::ivec3 at) { return at.x >= 40; };
  const auto volume = evenVolume(grid);
  const std::vector<Level> joins = regionOf(grid, [&](glm::ivec3 at) {
    return inBall(at, ball, 12.0) || inLeak(at) ||
           (at.x > 15 && glm::length(glm::dvec2(at.y, at.z) - glm::dvec2(30.0)) <= 4.0);
  });
  const glm::ivec3 inside(ball), outside(90, 30, 30);
  const auto taken = cutOff(*volume, joins, step, std::span(&inside, 1), std::span(&outside, 1),
                            {.perVolume = 0.1, .edge = infinity, .leak = 1000.0});
  const Shares shares = sharesOf(taken, joins, grid, inLeak);
  EXPECT_GT(shares.wanted, 0.99);
  EXPECT_LT(shares.others, 0.15) << "the neck's voxels may go with either";
  // Where no leak is expected, the block is too dear, and the seed takes the ball around it: a fifth.
  const auto spot =
      cutOff(*volume, joins, step, std::span(&inside, 1), std::span(&outside, 1), {.perVolume = 0.1, .edge = infinity});
  EXPECT_LT(sharesOf(spot, joins, grid, inLeak).wanted, 0.3);
}

TEST(RegionCut, ASeedAtTheSurfaceTakesASpot) {
  const auto volume = evenVolume(twoBalls);
  const std::vector<Level> joins = regionOf(twoBalls, inEither);
  const glm::ivec3 inside(left), outside(51, 16, 16);  // two voxels within the right ball
  const auto taken = cutOff(*volume, joins, step, std::span(&inside, 1), std::span(&outside, 1),
                            {.perVolume = 0.03, .edge = infinity});
  const Shares near = sharesOf(taken, joins, twoBalls, [&](glm::ivec3 at) { return inBall(at, outside, 5.0); });
  EXPECT_EQ(taken[twoBalls.offset(outside)], 1);
  EXPECT_EQ(near.others, 0.0);
}

TEST(RegionCut, ASeedAtTheSurfaceKeepsThePartThatItLiesIn) {
  // Both lie near the surface of one ball; the one outside holds the larger ball.
  const auto volume = evenVolume(twoBalls);
  const std::vector<Level> joins = regionOf(twoBalls, [](glm::ivec3 at) { return inBall(at, left, 13.0); });
  const glm::ivec3 inside(16, 16, 4), outside(16, 9, 8);
  const auto taken = cutOff(*volume, joins, step, std::span(&inside, 1), std::span(&outside, 1),
                            {.perVolume = 0.001, .edge = infinity});
  const auto count = static_cast<double>(std::ranges::count(joins, Level{0}));
  EXPECT_EQ(taken[twoBalls.offset(outside)], 1);
  EXPECT_LT(static_cast<double>(std::ranges::count(taken, 1)), 0.1 * count);
}

TEST(RegionCut, ACutThatWouldLeaveACrumbTakesTheSeedsBallAlone) {
  const auto volume = evenVolume(twoBalls);
  const std::vector<Level> joins = regionOf(twoBalls, inEither);
  const glm::ivec3 inside(left), outside(36, 16, 16);
  const CutCost cost{.perVolume = 0.03, .edge = infinity, .crumb = 1.2 * 9200.0};  // more than the left ball's mm³
  const auto taken = cutOff(*volume, joins, step, std::span(&inside, 1), std::span(&outside, 1), cost);
  EXPECT_EQ(taken[twoBalls.offset(outside)], 1);
  EXPECT_EQ(taken[twoBalls.offset({50, 16, 16})], 0);
  EXPECT_EQ(taken[twoBalls.offset(inside)], 0);
}

TEST(RegionCut, APartThatStillTouchesAtCornersStays) {
  // A rod of one voxel's thickness that goes on diagonally: nothing parts it but the seed's own voxel.
  const Grid grid = gridOf({40, 40, 5});
  const auto volume = evenVolume(grid);
  const std::vector<Level> joins =
      regionOf(grid, [](glm::ivec3 at) { return at.z == 2 && at.y >= 4 && at.y <= 35 && (at.x == at.y || at.x == 4); });
  const glm::ivec3 inside(4, 30, 2), outside(4, 34, 2);
  const auto taken = cutOff(*volume, joins, step, std::span(&inside, 1), std::span(&outside, 1),
                            {.perVolume = 0.001, .edge = infinity});
  EXPECT_EQ(taken[grid.offset(outside)], 1);
  EXPECT_EQ(taken[grid.offset({30, 30, 2})], 0);
}

TEST(RegionCut, TakesLittleWhereTheShapeDoesNotDecide) {
  // A rod, which is as narrow everywhere: the ball of the seed outside ends at x = 78.
  const Grid grid = gridOf({101, 9, 9});
  const auto volume = evenVolume(grid);
  const std::vector<Level> joins =
      regionOf(grid, [](glm::ivec3 at) { return at.y > 1 && at.y < 7 && at.z > 1 && at.z < 7; });
  const glm::ivec3 inside(20, 4, 4), outside(80, 4, 4);
  const auto taken = cutOff(*volume, joins, step, std::span(&inside, 1), std::span(&outside, 1),
                            {.perVolume = 0.003, .edge = infinity});
  for (int x = 0; x < 101; ++x) EXPECT_EQ(taken[grid.offset({x, 4, 4})], x >= 78) << x;
}

TEST(RegionCut, FollowsEdges) {
  // A bar of two tissues that meet at x = 20, far nearer to the seed outside's half.
  const Grid grid = gridOf({61, 17, 17});
  const auto volume = volumeOf<float>(grid, [](glm::ivec3 at) { return at.x <= 20 ? 0.0 : 100.0; });
  const std::vector<Level> joins = regionOf(grid, [](glm::ivec3) { return true; });
  const glm::ivec3 inside(8, 8, 8), outside(50, 8, 8);
  const auto taken =
      cutOff(*volume, joins, step, std::span(&inside, 1), std::span(&outside, 1), {.perVolume = 0.001, .edge = 10.0});
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) { ASSERT_EQ(taken[grid.offset(at)], at.x > 20) << at.x; });
}

TEST(RegionCut, ValuesThatAreNoNumbersStillConnect) {
  const Grid grid = gridOf({61, 17, 17});
  const auto volume = volumeOf<float>(grid, [](glm::ivec3 at) {
    return at.x == 30 ? tests::nan : at.x == 31 ? tests::infinity : 0.0;
  });
  const std::vector<Level> joins = regionOf(grid, [](glm::ivec3) { return true; });
  const glm::ivec3 inside(8, 8, 8), outside(15, 2, 2);
  const auto taken =
      cutOff(*volume, joins, step, std::span(&inside, 1), std::span(&outside, 1), {.perVolume = 0.03, .edge = 10.0});
  EXPECT_EQ(taken[grid.offset(outside)], 1);
  EXPECT_EQ(taken[grid.offset({60, 8, 8})], 0);  // behind the hole, and still connected with the seed
}

TEST(RegionCut, WhatIsPartedFromAllSeedsLeavesToo) {
  // Three balls in a row: the middle one is taken, and the third hangs on it.
  const Grid grid = gridOf({81, 33, 33});
  const auto ball = [](int number) { return glm::dvec3(16.0 + 24.0 * number, 16.0, 16.0); };
  const auto isIn = [&](glm::ivec3 at) {
    return inBall(at, ball(0), 13.0) || inBall(at, ball(1), 13.0) || inBall(at, ball(2), 13.0);
  };
  const auto volume = evenVolume(grid);
  const std::vector<Level> joins = regionOf(grid, isIn);
  const glm::ivec3 inside(ball(0)), outside(ball(1));
  const auto taken = cutOff(*volume, joins, step, std::span(&inside, 1), std::span(&outside, 1),
                            {.perVolume = 0.03, .edge = infinity});
  EXPECT_EQ(taken[grid.offset(glm::ivec3(ball(2)))], 1);
  EXPECT_EQ(taken[grid.offset(glm::ivec3(ball(0)))], 0);
  // With a seed of its own it stays.
  const std::vector<glm::ivec3> both{glm::ivec3(ball(0)), glm::ivec3(ball(2))};
  const auto fewer = cutOff(*volume, joins, step, both, std::span(&outside, 1), {.perVolume = 0.03, .edge = infinity});
  EXPECT_EQ(fewer[grid.offset(glm::ivec3(ball(2)))], 0);
  EXPECT_EQ(fewer[grid.offset(glm::ivec3(ball(1)))], 1);
}

TEST(RegionCut, SeedsBesideTheRegionTakeNothing) {
  const auto volume = evenVolume(twoBalls);
  const std::vector<Level> joins = regionOf(twoBalls, inLeft);
  const glm::ivec3 inside(left);
  for (const glm::ivec3 outside : {glm::ivec3(right), glm::ivec3(0)}) {
    const auto taken =
        cutOff(*volume, joins, step, std::span(&inside, 1), std::span(&outside, 1), {.perVolume = 0.03, .edge = 1.0});
    EXPECT_EQ(taken, std::vector<std::uint8_t>(joins.size(), 0));
  }
  const std::vector<Level> nothing(joins.size(), never);
  EXPECT_EQ(cutOff(*volume, nothing, step, std::span(&inside, 1), std::span(&inside, 1), {}),
            std::vector<std::uint8_t>(joins.size(), 0));
}

TEST(RegionCut, CoarseCellsFollowTheNeckOfALargeRegion) {
  // A million voxels in balls that touch in a neck: cells of two and more voxels along each side.
  const Grid grid = gridOf({190, 110, 110});
  const glm::dvec3 one(52.0, 55.0, 55.0), other(136.0, 55.0, 55.0);
  const auto inOne = [&](glm::ivec3 at) { return inBall(at, one, 46.0) && at.x <= 94; };
  const std::vector<Level> joins = regionOf(grid, [&](glm::ivec3 at) { return inOne(at) || inBall(at, other, 46.0); });
  const auto volume = evenVolume(grid);
  const glm::ivec3 inside(one), outside(other);
  const auto taken = cutOff(*volume, joins, step, std::span(&inside, 1), std::span(&outside, 1),
                            {.perVolume = 0.01, .edge = infinity});
  const Shares shares = sharesOf(taken, joins, grid, [&](glm::ivec3 at) { return !inOne(at); });
  EXPECT_GT(shares.wanted, 0.98);
  EXPECT_LT(shares.others, 0.02);
}

}  // namespace
}  // namespace fenestra::segmentation::regionCutTest
