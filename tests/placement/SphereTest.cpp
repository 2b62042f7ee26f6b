#include "rendering/viewpoints/Sphere.h"

#include <gtest/gtest.h>

namespace fenestra::placement {
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
      EXPECT_EQ(ringPixel(nside, directions[i]), static_cast<long>(i));
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
    for (long pixel = 0; pixel < 12L * nside * nside; ++pixel)
      for (long child = 4 * pixel; child < 4 * pixel + 4; ++child)
        EXPECT_EQ(ringPixel(nside, nestedDirection(2 * nside, child)), ringPixel(nside, nestedDirection(nside, pixel)));
}

}  // namespace
}  // namespace fenestra::placement
