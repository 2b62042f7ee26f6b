#include "rendering/viewpoints/Sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "rendering/viewpoints/Placement.h"

namespace fenestra::placement::sphereTest {
namespace {

TEST(Sphere, OnlyTwelveTimesASquareIsACount) {
  for (int nside = 1; nside <= 40; ++nside) {
    EXPECT_EQ(sideOf(12 * nside * nside), nside);
    EXPECT_EQ(sideOf(12 * nside * nside + 1), std::nullopt);
  }
  for (const int count : {-12, -1, 0, 1, 11, 24, 100, 184}) EXPECT_EQ(sideOf(count), std::nullopt) << count;
}

TEST(Sphere, DirectionsAreUnitDistinctAndBalanced) {
  for (const int nside : {1, 2, 3, 4, 5, 7, 10}) {
    const std::vector<glm::dvec3> directions = ringDirections(nside);
    ASSERT_EQ(directions.size(), static_cast<std::size_t>(12 * nside * nside));
    glm::dvec3 sum(0.0);
    double nearest = -1.0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      EXPECT_NEAR(glm::length(directions[i]), 1.0, 1e-14);
      EXPECT_EQ(ringPixel(nside, directions[i]), static_cast<int>(i));
      sum += directions[i];
      for (std::size_t j = 0; j < i; ++j) nearest = std::max(nearest, glm::dot(directions[i], directions[j]));
    }
    EXPECT_LT(glm::length(sum), 1e-10) << nside;
    // Pixels of equal area: neighbours are about the square root of 4π/N apart, never less than half of that.
    EXPECT_LT(nearest, std::cos(0.5 * std::sqrt(4.0 * 3.14159265 / static_cast<double>(directions.size())))) << nside;
  }
}

TEST(Sphere, ChildrenLieInTheirParent) {
  for (const int nside : {1, 2, 4, 8})
    for (int pixel = 0; pixel < 12 * nside * nside; ++pixel)
      for (int child = 4 * pixel; child < 4 * pixel + 4; ++child)
        EXPECT_EQ(ringPixel(nside, nestedDirection(2 * nside, child)), ringPixel(nside, nestedDirection(nside, pixel)));
}

TEST(Sphere, NeighboursArePixelsThatTouch) {
  for (const int nside : {2, 4, 8, 32}) {
    int seven = 0;
    for (int pixel = 0; pixel < 12 * nside * nside; ++pixel) {
      const std::vector<int> found = nestedNeighbours(nside, pixel);
      const std::set<int> neighbours(found.begin(), found.end());
      ASSERT_EQ(neighbours.size(), found.size()) << nside << ": " << pixel;
      EXPECT_FALSE(neighbours.contains(pixel));
      seven += found.size() == 7;
      EXPECT_TRUE(found.size() == 7 || found.size() == 8) << nside << ": " << pixel;
      for (const int neighbour : found) {
        const std::vector<int> back = nestedNeighbours(nside, neighbour);
        EXPECT_TRUE(std::find(back.begin(), back.end(), pixel) != back.end()) << nside << ": " << pixel;
      }
      // A step of 0.6 widths from the middle leaves a pixel across its edges, and does not pass over a neighbour.
      const glm::dvec3 middle = nestedDirection(nside, pixel);
      const Camera::Axes axes = axesAt(middle);
      const double step = 0.6 * std::sqrt(std::numbers::pi / 3.0) / nside;
      for (int i = 0; i < 64; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 64;
        const glm::dvec3 aside = std::cos(angle) * axes.right + std::sin(angle) * axes.up;
        const int met = nestedPixel(nside, std::cos(step) * middle + std::sin(step) * aside);
        EXPECT_TRUE(met == pixel || neighbours.contains(met)) << nside << ": " << pixel << " and " << met;
      }
    }
    EXPECT_EQ(seven, 24) << "three pixels meet at eight corners of the base pixels";
  }
}

}  // namespace
}  // namespace fenestra::placement::sphereTest
