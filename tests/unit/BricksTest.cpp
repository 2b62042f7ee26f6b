// Empty-space skipping on its own; the renderer's tests check that it changes no picture.

#include <random>

#include <gtest/gtest.h>

#include "rendering/gpu/Bricks.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests::bricksTest {
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

TEST(Bricks, OctantsHoldTheValuesAtTheirCellsAndLittleMore) {
  std::mt19937 random(7);
  const glm::ivec3 dims(13, 9, 6);
  const auto volume = volumeOf(gridOf(dims), [&](glm::ivec3 v) {
    return v.x < 6 ? -1000.0 : std::uniform_real_distribution(-900.0, 1500.0)(random);
  });
  const BrickRanges bricks = brickRanges({volume});
  ASSERT_EQ(bricks.octants.size(), bricks.ranges.size());
  std::vector<std::optional<ValueRange>> expected(8 * bricks.ranges.size());
  glm::ivec3 cell;
  for (cell.z = 0; cell.z <= dims.z; ++cell.z)
    for (cell.y = 0; cell.y <= dims.y; ++cell.y)
      for (cell.x = 0; cell.x <= dims.x; ++cell.x) {
        const glm::ivec3 octant = cell % brickSide / (brickSide / 2);
        auto& range = expected[8 * brickOffset(bricks.dims, cell / brickSide) +
                               static_cast<std::size_t>(octant.x + 2 * octant.y + 4 * octant.z)];
        for (int corner = 0; corner < 8; ++corner) {
          const glm::ivec3 voxel =
              glm::clamp(cell - 1 + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2), glm::ivec3(0), dims - 1);
          const double value = volume->value(voxel);
          range =
              range ? ValueRange{std::min(range->low, value), std::max(range->high, value)} : ValueRange{value, value};
        }
      }
  int air = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (!expected[i]) continue;  // beyond the volume
    const ValueRange& brick = bricks.ranges[i / 8];
    const ValueRange kept = rangeOf(bricks.octants[i / 8], i % 8, brick);
    const double step = (brick.high - brick.low) / 255.0;
    EXPECT_LE(kept.low, expected[i]->low) << i;
    EXPECT_GE(kept.high, expected[i]->high) << i;
    EXPECT_GE(kept.low, expected[i]->low - 1.001 * step) << i;
    EXPECT_LE(kept.high, expected[i]->high + 1.001 * step) << i;
    // An octant of air keeps exactly the value of air, so that a function that begins right above it shows nothing
    // there.
    air += expected[i]->high == -1000.0 && kept.high == -1000.0 && brick.high > -1000.0;
  }
  EXPECT_GT(air, 0);
}

TEST(Bricks, SkipTexelsHoldDistancesAndWhatShows) {
  EXPECT_EQ(skipTexels({4, 1, 1}, {0, 0, 0x12, wholeBrick}), (std::vector<std::uint16_t>{2, 1, 0x1200, 0xFF00}));
}

TEST(Bricks, ChebyshevDistanceEndsAtWhatAByteHolds) {
  std::vector<std::uint8_t> occupied(300, 0);
  occupied.front() = 1;
  const std::vector<std::uint8_t> distance = chebyshevDistance({300, 1, 1}, occupied);
  EXPECT_EQ(distance[254], 254);
  EXPECT_EQ(distance[299], 255);
}

}  // namespace
}  // namespace fenestra::tests::bricksTest
