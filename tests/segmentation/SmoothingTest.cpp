#include "rendering/segmentation/Smoothing.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::segmentation::smoothingTest {
namespace {

using tests::gridOf;
using tests::volumeOf;

std::shared_ptr<Volume> noisy(glm::ivec3 dims, double deviation, double step) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, deviation);
  return volumeOf<float>(gridOf(dims),
                         [&](glm::ivec3 at) { return noise(random) + (at.x >= dims.x / 2 ? step : 0.0); });
}

TEST(Smoothing, FindsTheNoiseBesideAnEdge) {
  // The median of 100 000 deviations scatters by less than a percent; the edge, a percent of them, shifts it by two.
  const Noise noise = noiseOf(*noisy({200, 24, 24}, 7.0, 300.0));
  EXPECT_NEAR(noise.deviation, 7.0, 0.2);
  EXPECT_EQ(noise.unit, noise.deviation);
}

TEST(Smoothing, GivesAVolumeWithoutNoiseAUnit) {
  const auto flat = volumeOf<std::uint8_t>(gridOf(glm::ivec3(8)), [](glm::ivec3) { return 5; });
  EXPECT_GT(noiseOf(*flat).unit, 0.0);
  const auto ball = volumeOf(gridOf(glm::ivec3(8)), [](glm::ivec3 at) { return at.x > 3 ? 1000.0 : 0.0; });
  EXPECT_GT(noiseOf(*ball).unit, 0.0);
}

TEST(Smoothing, TakesNoiseAndKeepsEdges) {
  const glm::ivec3 dims(40, 24, 24);
  const double noise = 10.0, step = 200.0;
  const auto volume = noisy(dims, noise, step);
  const VoxelBox box = wholeOf(dims);
  const std::vector<float> tones = smoothedTones(*volume, box, ToneScale(*volume, {noise, noise}, 0.0));
  double squares = 0.0, beside[2] = {0.0, 0.0};
  int flat = 0;
  tests::forEachVoxel(dims, [&](glm::ivec3 at) {
    const double tone = tones[box.offset(at)];
    if (at.x < 16) {
      squares += tone * tone;
      ++flat;
    }
    if (at.x == 19) beside[0] += tone;
    if (at.x == 20) beside[1] += tone;
  });
  EXPECT_LT(std::sqrt(squares / flat), 0.45) << "of one, before";
  const double faces = dims.y * dims.z;
  // A mean of 3×3×3 would leave a third of the step of 20.
  EXPECT_GT((beside[1] - beside[0]) / faces, 17.0);
}

TEST(Smoothing, LeavesAVolumeWithoutNoiseAsItIs) {
  const auto volume = volumeOf(gridOf(glm::ivec3(12)), [](glm::ivec3 at) { return at.x > 5 ? 10.0 : 0.0; });
  const VoxelBox box = wholeOf(volume->grid.dims);
  const std::vector<float> tones = smoothedTones(*volume, box, ToneScale(*volume, {0.0, 8.0}, 0.0));
  // The step is hardly more than a unit. Its variance of 0.35 is far above the filter's 0.001.
  tests::forEachVoxel(volume->grid.dims,
                      [&](glm::ivec3 at) { EXPECT_NEAR(tones[box.offset(at)], at.x > 5 ? 1.25 : 0.0, 0.01); });
}

TEST(Smoothing, DoesNotDependOnTheBox) {
  const auto volume = noisy({20, 18, 16}, 5.0, 60.0);
  const ToneScale scale(*volume, {5.0, 5.0}, 10.0);
  const VoxelBox all = wholeOf(volume->grid.dims), part{{0, 5, 7}, {13, 18, 12}};
  const std::vector<float> whole = smoothedTones(*volume, all, scale), some = smoothedTones(*volume, part, scale);
  for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(some[i], whole[all.offset(part.at(i))]);
}

TEST(Smoothing, ReadsStoredValuesThroughTheirScaling) {
  const Grid grid = gridOf(glm::ivec3(6));
  const auto stored = volumeOf<std::int16_t>(grid, [](glm::ivec3 at) { return 10 * at.x; });
  stored->slope = 2.0;
  stored->intercept = -30.0;
  stored->computeRange();
  const auto real = volumeOf(grid, [](glm::ivec3 at) { return 20.0 * at.x - 30.0; });
  const VoxelBox box = wholeOf(grid.dims);
  EXPECT_EQ(smoothedTones(*stored, box, ToneScale(*stored, {4.0, 4.0}, 0.0)),
            smoothedTones(*real, box, ToneScale(*real, {4.0, 4.0}, 0.0)));
}

TEST(Smoothing, CountsDifferencesBeyondTheDisplayWindowLess) {
  const auto ct = volumeOf<std::int16_t>(gridOf(glm::ivec3(4)), [](glm::ivec3 at) { return at.x ? 1000 : -1000; });
  ASSERT_TRUE(ct->isInHounsfieldUnits());
  const ToneScale scale(*ct, {10.0, 10.0}, 40.0);  // the window is -160…240
  EXPECT_DOUBLE_EQ(scale(140.0), 10.0);
  EXPECT_DOUBLE_EQ(scale(340.0) - scale(240.0), 3.0);
  EXPECT_DOUBLE_EQ(scale(-160.0) - scale(-260.0), 3.0);
  for (const double real : {-900.0, -160.0, 0.0, 240.0, 1000.0})
    EXPECT_NEAR(scale.linear(static_cast<float>(scale(real))), (real - 40.0) / 10.0, 1e-4) << "a float's digits";
}

TEST(Smoothing, TakesNanAsTheLeastValue) {
  const auto volume = volumeOf<float>(gridOf(glm::ivec3(6)), [](glm::ivec3 at) {
    return at.x == 3 ? std::numeric_limits<double>::quiet_NaN() : at.x == 4 ? tests::infinity : 7.0 + at.y;
  });
  for (const float tone : smoothedTones(*volume, wholeOf(glm::ivec3(6)), ToneScale(*volume, {1.0, 1.0}, 7.0)))
    EXPECT_TRUE(std::isfinite(tone));
  EXPECT_TRUE(std::isfinite(noiseOf(*volume).unit));
}

}  // namespace
}  // namespace fenestra::segmentation::smoothingTest
