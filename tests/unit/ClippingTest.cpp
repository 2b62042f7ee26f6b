// The half-spaces of a crop box and of planes in volumes of any orientation.

#include <gtest/gtest.h>

#include "rendering/settings/Clipping.h"
#include "rendering/settings/LookStyle.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests::clippingTest {
namespace {

void expectNear(glm::dvec3 a, glm::dvec3 b, double tolerance = 1e-9) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance) << axis;
}

TEST(CropFrame, IsThePatientsWhereTheVolumeIs) {
  const Grid grid = gridOf({10, 20, 30}, {1.0, 0.5, 2.0}, {-3.0, 40.0, 7.0});
  const CropFrame frame(grid);
  EXPECT_EQ(frame.axis, glm::ivec3(0, 1, 2));
  expectNear(frame.coordinates({1.0, 2.0, 3.0}), {1.0, 2.0, 3.0});
  expectNear(frame.low, {-3.5, 39.75, 6.0});
  expectNear(frame.high, {6.5, 49.75, 66.0});
}

TEST(CropFrame, IsThePatientsWhereAxesAreSwappedAndReversed) {
  // Sagittal slices from right to left: rows run to posterior, columns to inferior.
  Grid grid = gridOf({20, 30, 10}, {0.5, 2.0, 1.0}, {-3.0, 40.0, 7.0});
  grid.direction = glm::dmat3(glm::dvec3(0, 1, 0), glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0));
  const CropFrame frame(grid);
  EXPECT_EQ(frame.axis, glm::ivec3(2, 0, 1));
  expectNear(frame.coordinates({1.0, 2.0, 3.0}), {1.0, 2.0, 3.0});
  expectNear(frame.low, {-3.5, 39.75, -52.0});
  expectNear(frame.high, {6.5, 49.75, 8.0});
}

TEST(CropFrame, FollowsTheFacesOfObliqueAndShearedVolumes) {
  Grid sheared = gridOf({10, 12, 14});
  sheared.direction[2] = glm::normalize(glm::dvec3(0.0, 0.3, 1.0));  // a tilted gantry
  for (const Grid& grid : {obliqueGrid({10, 12, 14}), sheared}) {
    const CropFrame frame(grid);
    const glm::dmat4 worldFromIndex = grid.worldFromIndex();
    for (int patient = 0; patient < 3; ++patient) {
      // A step along another index axis stays on the face.
      const glm::dvec3 normal = frame.normal[static_cast<std::size_t>(patient)];
      for (int axis = 0; axis < 3; ++axis)
        if (axis != frame.axis[patient]) {
          EXPECT_NEAR(glm::dot(normal, grid.direction[axis]), 0.0, 1e-12);
        }
      EXPECT_NEAR(glm::length(normal), 1.0, 1e-12);
      EXPECT_GT(normal[patient], 0.0);
    }
    const glm::dvec3 world(worldFromIndex * glm::dvec4(3.0, 4.0, 5.0, 1.0));
    expectNear(frame.world(frame.coordinates(world)), world);
  }
}

TEST(Clipping, ABoxAsLargeAsTheVolumeOrLargerClipsNothing) {
  for (const Grid& grid : {gridOf({10, 20, 30}), obliqueGrid({10, 12, 14})}) {
    const CropFrame frame(grid);
    Clipping clipping;
    clipping.cropped = true;
    clipping.box = {frame.low, frame.high};
    EXPECT_TRUE(halfSpaces(clipping, grid).empty());
    clipping.box = {frame.low - 5.0, frame.high + 1e9};
    EXPECT_TRUE(halfSpaces(clipping, grid).empty());
    clipping.box.low.y += 6.0;
    ASSERT_EQ(halfSpaces(clipping, grid).size(), 1u);
    EXPECT_EQ(halfSpaces(clipping, grid)[0].normal, frame.normal[1]);
    clipping.cropped = false;
    EXPECT_TRUE(halfSpaces(clipping, grid).empty());
  }
}

TEST(Clipping, KeepsWhatLiesInTheBoxAndBeforeThePlanes) {
  const Grid grid = gridOf({20, 20, 20});
  Clipping clipping;
  clipping.cropped = true;
  clipping.box = {{3.0, -1e3, 4.0}, {15.0, 1e3, 16.0}};
  clipping.planes = {{glm::normalize(glm::dvec3(1.0, 1.0, 0.0)), 10.0}};
  const std::vector<HalfSpace> kept = halfSpaces(clipping, grid);
  EXPECT_EQ(kept.size(), 5u);
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 p = randomIn(random, glm::dvec3(-1.0), glm::dvec3(20.0));
    const bool inside = p.x >= 3.0 && p.x <= 15.0 && p.z >= 4.0 && p.z <= 16.0 && p.x + p.y >= 10.0 * std::sqrt(2.0);
    EXPECT_EQ(keeps(kept, p), inside) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

TEST(Clipping, StaysWithItsDataWhenTheStyleChanges) {
  Look look, other;
  look.clipping.planes = {{}};
  other.clipping.cropped = true;
  other.shading.ambient = 0.6;
  const Look result = restyled(look, other);
  EXPECT_EQ(result.clipping, look.clipping);
  EXPECT_EQ(result.shading.ambient, 0.6);
  EXPECT_EQ(styleOf(look).clipping, Clipping());
}

}  // namespace
}  // namespace fenestra::tests::clippingTest
