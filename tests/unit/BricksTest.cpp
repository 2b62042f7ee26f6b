// Empty-space skipping on its own; the renderer's tests check that it changes no picture.

#include <random>

#include <gtest/gtest.h>

#include "rendering/gpu/Bricks.h"

namespace fenestra::tests {
namespace {

std::uint8_t nearestByHand(glm::ivec3 dims, const std::vector<std::uint8_t>& occupied, glm::ivec3 from) {
  int nearest = 255;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        if (occupied[brickOffset(dims, {x, y, z})])
          nearest = std::min(nearest, std::max({std::abs(x - from.x), std::abs(y - from.y), std::abs(z - from.z)}));
  return static_cast<std::uint8_t>(nearest);
}

TEST(Bricks, ChebyshevDistanceIsThatOfTheNearestOccupiedOne) {
  std::mt19937 random(5);
  for (const glm::ivec3 dims : {glm::ivec3(9, 7, 8), glm::ivec3(1, 12, 3), glm::ivec3(13, 1, 1), glm::ivec3(1, 1, 1)})
    for (const double share : {0.0, 0.01, 0.1, 0.5, 1.0}) {
      std::vector<std::uint8_t> occupied(static_cast<std::size_t>(dims.x * dims.y * dims.z));
      for (std::uint8_t& brick : occupied) brick = std::bernoulli_distribution(share)(random);
      const std::vector<std::uint8_t> distance = chebyshevDistance(dims, occupied);
      ASSERT_EQ(distance.size(), occupied.size());
      for (int z = 0; z < dims.z; ++z)
        for (int y = 0; y < dims.y; ++y)
          for (int x = 0; x < dims.x; ++x)
            EXPECT_EQ(distance[brickOffset(dims, {x, y, z})], nearestByHand(dims, occupied, {x, y, z}))
                << x << ' ' << y << ' ' << z << " of " << dims.x << ' ' << dims.y << ' ' << dims.z << ", " << share;
    }
}

TEST(Bricks, ChebyshevDistanceEndsAtWhatAByteHolds) {
  std::vector<std::uint8_t> occupied(300, 0);
  occupied.front() = 1;
  const std::vector<std::uint8_t> distance = chebyshevDistance({300, 1, 1}, occupied);
  EXPECT_EQ(distance[254], 254);
  EXPECT_EQ(distance[299], 255);
}

}  // namespace
}  // namespace fenestra::tests
