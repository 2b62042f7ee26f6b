#include "rendering/gpu/FocusSmooth.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "rendering/gpu/FocusIndexing.h"
#include "rendering/gpu/LabelIndex.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests::focusSmoothTest {
namespace {

/// The filter's value at a voxel as one sum, in [0, 1]; labels repeat at the volume's edge.
template <class InsideAt>
double expectedAt(glm::ivec3 voxel, glm::ivec3 dims, InsideAt insideAt) {
  // (1 4 6 4 1)/16 twice: the binomials of 8.
  constexpr std::array<double, 9> weights{1, 8, 28, 56, 70, 56, 28, 8, 1};
  double sum = 0.0;
  for (int z = -4; z <= 4; ++z)
    for (int y = -4; y <= 4; ++y)
      for (int x = -4; x <= 4; ++x)
        if (insideAt(glm::clamp(voxel + glm::ivec3(x, y, z), glm::ivec3(0), dims - 1)))
          sum += weights[static_cast<std::size_t>(x + 4)] * weights[static_cast<std::size_t>(y + 4)] *
                 weights[static_cast<std::size_t>(z + 4)];
  return sum / (256.0 * 256.0 * 256.0);
}

template <class InsideAt>
void expectSmooth(glm::ivec3 dims, InsideAt insideAt) {
  Scene scene;
  const Grid grid = gridOf(dims);
  scene.volume = volumeOf(grid, [](glm::ivec3 v) { return double(v.x); });
  scene.labels = labelsOf(grid, [&](glm::ivec3 v) { return insideAt(v) ? 7 : v.x % 3; });
  scene.look.focus = LabelFocus{{7, 9}};
  const FocusIndex index = buildFocusIndex(scene, brickRanges(shownVolume(scene)));
  ASSERT_TRUE(index.box);
  const FocusSmooth smooth(index, dims);
  const SmoothBox& box = smooth.box();
  EXPECT_TRUE(glm::all(glm::lessThanEqual(box.origin, index.box->low - 5)));
  EXPECT_TRUE(glm::all(glm::greaterThanEqual(box.origin + box.size, index.box->high + 6)));
  for (int axis = 0; axis < 3; ++axis) EXPECT_FALSE(std::has_single_bit(static_cast<unsigned>(box.size[axis])));
  // Two passes round: to a 16384th, and to a 65535th; half a step is lost at most. Scaling drops less than one of 2²².
  const double rounding = 0.5 / 16384.0 + 0.5 / 65535.0 + 1.0 / 4194304.0;
  const std::vector<glm::ivec3> filled = smooth.tiles();
  forEachVoxel(box.size / FocusSmooth::tileSide, [&](glm::ivec3 at) {
    const glm::ivec3 tile = box.origin + at * FocusSmooth::tileSide;
    FocusSmooth::Tile voxels;
    smooth.make(tile, voxels);
    const bool isFilled = std::find(filled.begin(), filled.end(), tile) != filled.end();
    std::size_t offset = 0;
    forEachVoxel(glm::ivec3(FocusSmooth::tileSide), [&](glm::ivec3 step) {
      const std::uint16_t value = voxels[offset++];
      ASSERT_NEAR(value / 65535.0, expectedAt(tile + step, dims, insideAt), rounding)
          << tile.x + step.x << ' ' << tile.y + step.y << ' ' << tile.z + step.z;
      ASSERT_TRUE(isFilled || value == 0);
    });
  });
}

TEST(FocusSmooth, Thorough_IsAGaussianOfTheFocus) {
  // Large enough that tiles lie wholly inside and wholly outside.
  expectSmooth({61, 58, 57}, [](glm::ivec3 v) {
    return glm::distance(glm::dvec3(v), glm::dvec3(31, 28, 27)) < 23.5 || v == glm::ivec3(3, 50, 50);
  });
}

TEST(FocusSmooth, OtherTilesThanThoseNearChangedBricksStay) {
  // Sizes at which the space beyond the volume fills tiles of its own, and sizes at which it does not.
  std::mt19937 random(8);
  for (const glm::ivec3 dims : {glm::ivec3(45, 37, 29), glm::ivec3(32, 28, 27), glm::ivec3(16, 1, 33)})
    for (int run = 0; run < 12; ++run) {
      const auto labels = labelsOf(gridOf(dims), [&](glm::ivec3 v) {
        const bool isCorner = v == glm::ivec3(0) || v == dims - 1;  // so that the box stays
        return isCorner ? 1 : random() % 400 == 0 ? 2 + random() % 3 : 0;
      });
      LabelIndexer indexer(labels);
      FocusIndex before, after;
      indexer.update(before, {1, 2});
      const FocusSmooth old(before, dims);
      after = before;
      const LabelIndexer::Change change = indexer.update(after, {1, 2, 3});
      const FocusSmooth now(after, dims);
      ASSERT_EQ(now.box(), old.box());
      const std::vector<glm::ivec3> near = now.tilesNear(change.bricks);
      forEachVoxel(now.box().size / FocusSmooth::tileSide, [&](glm::ivec3 at) {
        const glm::ivec3 tile = now.box().origin + at * FocusSmooth::tileSide;
        if (std::find(near.begin(), near.end(), tile) != near.end()) return;
        FocusSmooth::Tile here, there;
        old.make(tile, here);
        now.make(tile, there);
        ASSERT_EQ(here, there) << tile.x << ' ' << tile.y << ' ' << tile.z;
      });
    }
}

TEST(FocusSmooth, RepeatsTheVolumesEdge) {
  expectSmooth({19, 12, 9}, [](glm::ivec3 v) { return v.x < 11 && v.y > 3; });
  expectSmooth({20, 9, 1}, [](glm::ivec3 v) { return v.x == 19 && v.y == 0; });
}

}  // namespace
}  // namespace fenestra::tests::focusSmoothTest
