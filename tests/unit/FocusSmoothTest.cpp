#include "rendering/gpu/FocusSmooth.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::tests {
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
  const FocusSmooth smooth = smoothFocus(*scene.labels, std::get<LabelFocus>(scene.look.focus), index);
  EXPECT_EQ(smooth.origin, index.box->low - 5);
  EXPECT_EQ(smooth.size, index.box->high - index.box->low + 11);
  // Each of six passes rounds by half a step at most, and passes it on undiminished.
  const double rounding = 6 * 0.5 / 65535.0;
  forEachVoxel(smooth.size, [&](glm::ivec3 at) {
    const std::size_t offset = static_cast<std::size_t>(at.x + smooth.size.x * (at.y + smooth.size.y * at.z));
    ASSERT_NEAR(smooth.field[offset] / 65535.0, expectedAt(smooth.origin + at, dims, insideAt), rounding)
        << at.x << ' ' << at.y << ' ' << at.z;
  });
}

TEST(FocusSmooth, IsAGaussianOfTheFocus) {
  // Large enough that tiles lie wholly inside and wholly outside.
  expectSmooth({61, 58, 57}, [](glm::ivec3 v) {
    return glm::distance(glm::dvec3(v), glm::dvec3(31, 28, 27)) < 23.5 || v == glm::ivec3(3, 50, 50);
  });
}

TEST(FocusSmooth, RepeatsTheVolumesEdge) {
  expectSmooth({19, 12, 9}, [](glm::ivec3 v) { return v.x < 11 && v.y > 3; });
  expectSmooth({20, 9, 1}, [](glm::ivec3 v) { return v.x == 19 && v.y == 0; });
}

}  // namespace
}  // namespace fenestra::tests
