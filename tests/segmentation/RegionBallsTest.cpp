#include "rendering/segmentation/RegionBalls.h"

#include <gtest/gtest.h>

#include "tests/segmentation/MadeRegions.h"

namespace fenestra::segmentation::regionBallsTest {
namespace {

using tests::regionOf;

constexpr int step = 5;

TEST(RegionBalls, MeasureInMillimetres) {
  const Grid grid = tests::gridOf({41, 41, 41}, {1.0, 1.0, 2.0});
  const glm::dvec3 centre(20.0, 20.0, 40.0);  // mm
  const auto isIn = [&](glm::ivec3 at) { return glm::length(glm::dvec3(at) * grid.spacing - centre) <= 12.0; };
  const std::vector<Level> joins = regionOf(grid, isIn);
  const RegionBalls balls(grid, joins, step);
  EXPECT_NEAR(balls.ballAt({20, 20, 20}).radius, 12.0, 1.0) << "to a voxel's side";
  EXPECT_NEAR(balls.ballAt({28, 20, 20}).radius, 4.0, 1.0);
  EXPECT_NEAR(balls.bodyOf(balls.ballAt({28, 20, 20})).radius, 12.0, 1.0);
}

TEST(RegionBalls, AFaceOfTheVolumeBoundsNoDepth) {
  const Grid grid = tests::gridOf({41, 41, 21});
  const glm::dvec3 centre(20.0, 20.0, 20.0);  // in the last slice
  const auto isIn = [&](glm::ivec3 at) { return glm::length(glm::dvec3(at) - centre) <= 12.0; };
  const std::vector<Level> joins = regionOf(grid, isIn);
  const RegionBalls balls(grid, joins, step);
  const HeldBall inFace = balls.ballAt({20, 20, 20}), within = balls.ballAt({20, 20, 14});
  EXPECT_EQ(inFace.radius, 1.0);
  EXPECT_NEAR(inFace.depth, 12.0, 1.0) << "to a voxel's side";
  EXPECT_NEAR(within.radius, 6.0, 1.0);
  EXPECT_NEAR(within.depth, 6.0, 1.0);
  EXPECT_NEAR(balls.depthOf(within), 12.0, 1.0);
  EXPECT_NEAR(balls.bodyOf(within).radius, 6.0, 1.0) << "between the face and the surface";
}

}  // namespace
}  // namespace fenestra::segmentation::regionBallsTest
