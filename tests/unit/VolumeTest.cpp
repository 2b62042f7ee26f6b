#include "rendering/scene/Thinned.h"
#include "rendering/volume/Volume.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::volumeTest {
namespace {

using namespace tests;

TEST(Volume, valueAppliesTheRescale) {
  auto volume = volumeOf<std::int16_t>(gridOf({2, 1, 1}), [](glm::ivec3 i) { return i.x == 0 ? -32768 : 32767; });
  volume->slope = 0.5;
  volume->intercept = -1024.0;
  EXPECT_DOUBLE_EQ(volume->value({0, 0, 0}), -17408.0);
  EXPECT_DOUBLE_EQ(volume->value({1, 0, 0}), 15359.5);
}

TEST(Volume, sampleReproducesAMultilinearFunction) {
  const auto f = [](glm::dvec3 p) { return 3.0 + p.x - 2.0 * p.y + 0.5 * p.z + 0.25 * p.x * p.y * p.z; };
  const auto volume = volumeOf(gridOf({3, 4, 5}), [&](glm::ivec3 i) { return f(glm::dvec3(i)); });
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    // One cell at a time: only there is the interpolant that function.
    const glm::dvec3 p = randomIn(random, {0, 0, 0}, {1, 1, 1});
    EXPECT_NEAR(volume->sample(p), f(p), 1e-12);
  }
  forEachVoxel(volume->grid.dims, [&](glm::ivec3 i) { EXPECT_EQ(volume->sample(glm::dvec3(i)), volume->value(i)); });
}

TEST(Volume, sampleClampsToTheEdge) {
  const auto volume = volumeOf(gridOf({3, 3, 1}), [](glm::ivec3 i) { return i.x + 10.0 * i.y; });
  EXPECT_EQ(volume->sample({-5.0, 1.0, 0.0}), 10.0);
  EXPECT_EQ(volume->sample({99.0, 1.0, 0.0}), 12.0);
  EXPECT_EQ(volume->sample({1.0, 1.0, -0.5}), 11.0);
  EXPECT_EQ(volume->sample({1.0, 1.0, 0.5}), 11.0);
}

TEST(Volume, rangeLeavesOutWhatIsNotFinite) {
  const double values[] = {nan, infinity, -3.0, 8.0, -infinity, 1e30};
  const auto volume = volumeOf<float>(gridOf({6, 1, 1}), [&](glm::ivec3 i) { return values[i.x]; });
  EXPECT_EQ(volume->range.low, -3.0);
  EXPECT_EQ(volume->range.high, static_cast<double>(1e30f));
}

TEST(Volume, rangeOfNothingFiniteIsZero) {
  const auto volume = volumeOf<float>(gridOf({2, 1, 1}), [](glm::ivec3) { return nan; });
  EXPECT_EQ(volume->range, (ValueRange{0.0, 0.0}));
}

TEST(Volume, rangeFollowsANegativeSlope) {
  auto volume = volumeOf<std::uint16_t>(gridOf({2, 1, 1}), [](glm::ivec3 i) { return i.x * 65535; });
  volume->slope = -2.0;
  volume->intercept = 1.0;
  volume->computeRange();
  EXPECT_EQ(volume->range, (ValueRange{1.0 - 2.0 * 65535.0, 1.0}));
}

TEST(Volume, rangeIsTheSameOnManyThreads) {
  // Large enough that the work is split.
  const auto volume = volumeOf<std::int16_t>(gridOf({256, 128, 128}), [](glm::ivec3 i) {
    return i == glm::ivec3(255, 127, 127) ? 32767 : i == glm::ivec3(0) ? -32768 : i.x - i.y;
  });
  EXPECT_EQ(volume->range, (ValueRange{-32768.0, 32767.0}));
}

TEST(Volume, defaultWindowIsTheFilesOwn) {
  auto volume = volumeOf(gridOf({2, 2, 2}), [](glm::ivec3 i) { return i.x; });
  volume->windows = {{400.0, 40.0}, {2000.0, 350.0}};
  EXPECT_EQ(volume->defaultWindow(), (WindowLevel{400.0, 40.0}));
}

TEST(Volume, defaultWindowSpansTheBulkOfTheValues) {
  // 0 … 99 evenly, and one voxel far out, which must not flatten the picture.
  const auto volume = volumeOf(gridOf({100, 10, 10}),
                               [](glm::ivec3 i) { return i == glm::ivec3(0) ? 150.0 : static_cast<double>(i.x); });
  const WindowLevel window = volume->defaultWindow();
  // Percentiles are read from 1024 bins over 150 values.
  EXPECT_NEAR(window.level - 0.5 * window.width, 1.0, 1.0);
  EXPECT_NEAR(window.level + 0.5 * window.width, 98.0, 1.0);
}

TEST(Volume, defaultWindowOfAConstantHasAWidth) {
  const auto volume = volumeOf(gridOf({4, 4, 4}), [](glm::ivec3) { return 7.0; });
  EXPECT_GT(volume->defaultWindow().width, 0.0);
  EXPECT_EQ(volume->defaultWindow().level, 7.0);
}

}  // namespace
TEST(Voxels, AnAllocationThatFailsNamesItsSize) {
#if !defined(__SANITIZE_ADDRESS__)  // ends a program that asks for this much
  try {
    const Voxels voxels(ScalarType::Float64, std::size_t{1} << 55);
    FAIL() << "no machine has 288 petabytes";
  } catch (const std::bad_alloc& error) {
    EXPECT_NE(std::string(error.what()).find("288230376151 MB"), std::string::npos) << error.what();
  }
#endif
  EXPECT_THROW(Voxels(ScalarType::Float64, std::size_t{1} << 62), VoxelAllocationError) << "bytes overflow";
}

TEST(Thinned, VoxelsAreTheMeansOfTheirBlocks) {
  const Grid grid = tests::obliqueGrid({5, 4, 3});
  const auto volume =
      tests::volumeOf<std::int16_t>(grid, [](glm::ivec3 v) { return 10 * v.x + 100 * v.y + 1000 * v.z; });
  const auto thin = thinned(ShownVolume{volume}, {2, 1, 3});
  EXPECT_EQ(thin->grid.dims, glm::ivec3(3, 4, 1));
  EXPECT_EQ(thin->value({0, 0, 0}), 1005.0);
  EXPECT_EQ(thin->value({2, 1, 0}), 1140.0) << "half a block";
  EXPECT_EQ(thin->range, volume->range);
  // Values of a ramp lie where they did.
  const glm::dvec3 at(thin->grid.worldFromIndex() * glm::dvec4(1, 2, 0, 1));
  const glm::dvec3 index(grid.indexFromWorld() * glm::dvec4(at, 1.0));
  EXPECT_NEAR(thin->value({1, 2, 0}), volume->sample(index), 0.5);
}

TEST(Thinned, NotANumberCountsForNothing) {
  const auto volume = tests::volumeOf<float>(tests::gridOf({4, 1, 1}), [](glm::ivec3 v) {
    return v.x == 0 ? 7.0 : v.x == 1 ? tests::nan : tests::infinity;
  });
  const auto thin = thinned(ShownVolume{volume}, {2, 1, 1});
  EXPECT_EQ(thin->value({0, 0, 0}), 7.0);
  EXPECT_TRUE(std::isnan(thin->value({1, 0, 0})));
}

TEST(Thinned, LabelsAreThoseInTheMiddle) {
  const auto labels = tests::labelsOf(tests::gridOf({5, 3, 3}), [](glm::ivec3 v) { return v.x + 1; });
  const auto thin = thinned(*labels, {3, 3, 3});
  EXPECT_EQ(thin->grid.dims, glm::ivec3(2, 1, 1));
  EXPECT_EQ(thin->value({0, 0, 0}), 2);
  EXPECT_EQ(thin->value({1, 0, 0}), 5);
}

/// 30³ voxels whose values `at` gives by a number from 0 to 1, evenly spread.
template <class F>
bool looksLikeCtOf(F&& at) {
  constexpr int side = 30;
  auto volume = volumeOf<float>(gridOf({side, side, side}), [&](glm::ivec3 i) {
    return static_cast<float>(at(((i.z * side + i.y) * side + i.x) / (1.0 * side * side * side)));
  });
  volume->computeRange();
  return looksLikeCt(*volume);
}

TEST(Volume, LooksLikeACtWhereItsValuesArePlausibleHounsfieldUnits) {
  // Air, fat and muscle, a little lung and bone, as in a patient; with and without padding.
  const auto patient = [](double share) {
    return share < 0.4 ? -1000.0 + 50.0 * share : share < 0.45 ? -800.0 : share < 0.9 ? -100.0 + 200.0 * share : 900.0;
  };
  EXPECT_TRUE(looksLikeCtOf(patient));
  EXPECT_TRUE(looksLikeCtOf([&](double share) { return share < 0.2 ? -3024.0 : patient(share); }));
  // The patient's values in other units, as converters write them.
  EXPECT_FALSE(looksLikeCtOf([&](double share) { return patient(share) + 1024.0; }));
  EXPECT_FALSE(looksLikeCtOf([&](double share) { return (patient(share) + 1024.0) / 4000.0; }));
  // Fields of signed values: phase, a field map, a displacement.
  EXPECT_FALSE(looksLikeCtOf([](double share) { return -4096.0 + 8190.0 * share; }));
  EXPECT_FALSE(looksLikeCtOf([](double share) { return -1000.0 + 2000.0 * share; }));
  EXPECT_FALSE(looksLikeCtOf([](double share) { return -500.0 + 1000.0 * share * share; }));
  EXPECT_FALSE(looksLikeCtOf([](double share) { return share < 0.9 ? 0.0 : -2000.0 + 2200.0 * (share - 0.9) * 10.0; }));
}

}  // namespace fenestra::volumeTest
