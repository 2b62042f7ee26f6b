// What the voxels of labels measure, against a computation that shares nothing with it.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "rendering/volume/LabelStatistics.h"

namespace fenestra::label_statistics_test {
namespace {

Grid sheared() {
  Grid grid;
  grid.dims = {37, 29, 23};
  grid.spacing = {0.7, 0.9, 2.5};
  grid.direction[0] = glm::normalize(glm::dvec3(1.0, 0.2, -0.1));
  grid.direction[1] = glm::normalize(glm::dvec3(-0.2, 1.0, 0.3));
  grid.direction[2] = glm::normalize(glm::dvec3(0.1, -0.3, 1.0));
  grid.origin = {-40.0, 1000.0, 7.0};
  return grid;
}

/// Labels in runs of random length, and values between `low` and `low` + 1000, some of them no number.
struct Random {
  LabelMap labels;
  Volume volume;

  explicit Random(double low, bool withoutNumbers = false) {
    std::mt19937 random(7);
    labels.grid = volume.grid = sheared();
    labels.voxels = Voxels(ScalarType::UInt16, labels.grid.voxelCount());
    volume.voxels = Voxels(ScalarType::Float32, labels.grid.voxelCount());
    auto values = volume.voxels.as<float>();
    auto marks = labels.voxels.as<std::uint16_t>();
    constexpr std::uint16_t kinds[] = {0, 1, 3, 700};
    std::uint16_t now = 0;
    for (std::size_t i = 0; i < marks.size(); ++i) {
      if (random() % 9 == 0) now = kinds[random() % 4];
      marks[i] = now;
      values[i] = static_cast<float>(random() % 4000) * 0.25F;
      if (withoutNumbers && random() % 11 == 0) values[i] = std::numeric_limits<float>::quiet_NaN();
    }
    volume.slope = 1.0;
    volume.intercept = low;
    for (const std::uint16_t value : {1, 3, 5, 700}) labels.labels.push_back({value, std::to_string(value)});
  }
};

/// Statistics by two passes in extended precision, voxel by voxel.
struct Expected {
  std::size_t voxels = 0;
  std::vector<long double> values;
  glm::dvec3 low{1e300}, high{-1e300}, sum{0.0};

  long double mean() const {
    long double all = 0.0L;
    for (const long double value : values) all += value;
    return all / static_cast<long double>(values.size());
  }
  long double deviation() const {
    const long double middle = mean();
    long double all = 0.0L;
    for (const long double value : values) all += (value - middle) * (value - middle);
    return std::sqrt(all / static_cast<long double>(values.size() - 1));
  }
};

std::map<std::uint16_t, Expected> expectedOf(const Random& data) {
  std::map<std::uint16_t, Expected> result;
  const Grid& grid = data.labels.grid;
  for (int z = 0; z < grid.dims.z; ++z)
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x) {
        Expected& expected = result[data.labels.value({x, y, z})];
        ++expected.voxels;
        if (const double value = data.volume.value({x, y, z}); std::isfinite(value)) expected.values.push_back(value);
        for (int corner = 0; corner < 8; ++corner) {
          const glm::dvec3 index = glm::dvec3(x, y, z) + glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2) - 0.5;
          const glm::dvec3 world(grid.worldFromIndex() * glm::dvec4(index, 1.0));
          expected.low = glm::min(expected.low, world);
          expected.high = glm::max(expected.high, world);
          expected.sum += world / 8.0;
        }
      }
  return result;
}

void expectSame(const Random& data, double tolerance) {
  const std::map<std::uint16_t, Expected> all = expectedOf(data);
  const std::vector<LabelStatistics> found = labelStatistics(data.labels, data.volume);
  ASSERT_EQ(found.size(), data.labels.labels.size());
  for (const LabelStatistics& of : found) {
    SCOPED_TRACE(of.label);
    if (of.label == 5) {
      EXPECT_EQ(of.voxels, 0u) << "the file names it, and no voxel has it";
      EXPECT_EQ(of.millilitres, 0.0);
      continue;
    }
    const Expected& expected = all.at(of.label);
    EXPECT_EQ(of.voxels, expected.voxels);
    EXPECT_EQ(of.valued, expected.values.size());
    const glm::dmat3 steps(data.labels.grid.worldFromIndex());
    const double voxel = std::abs(glm::dot(glm::cross(steps[0], steps[1]), steps[2])) / 1000.0;
    EXPECT_NEAR(of.millilitres, static_cast<double>(expected.voxels) * voxel, 1e-9);
    EXPECT_NEAR(of.mean, static_cast<double>(expected.mean()), tolerance);
    EXPECT_NEAR(of.deviation, static_cast<double>(expected.deviation()), tolerance);
    EXPECT_EQ(of.least, *std::min_element(expected.values.begin(), expected.values.end()));
    EXPECT_EQ(of.greatest, *std::max_element(expected.values.begin(), expected.values.end()));
    for (int k = 0; k < 3; ++k) {  // rounding of places metres away
      EXPECT_NEAR(of.low[k], expected.low[k], 1e-9);
      EXPECT_NEAR(of.high[k], expected.high[k], 1e-9);
      EXPECT_NEAR(of.centre[k], expected.sum[k] / static_cast<double>(expected.voxels), 1e-9);
    }
  }
}

TEST(LabelStatistics, AreThoseOfTheVoxelsOneByOne) { expectSame(Random(0.0), 1e-9); }

// Naive sums of squares of values at 1e9 are off by thousands. Twelve digits of a double stay below a value's unit.
TEST(LabelStatistics, KeepTheirDigitsFarFromZero) { expectSame(Random(1e9), 1e-5); }

TEST(LabelStatistics, LeaveOutWhatIsNoNumber) { expectSame(Random(0.0, true), 1e-9); }

TEST(LabelStatistics, OneVoxelHasNoDeviation) {
  Random data(0.0);
  auto marks = data.labels.voxels.as<std::uint16_t>();
  for (std::uint16_t& mark : marks) mark = 0;
  marks[100] = 3;
  const LabelStatistics only = labelStatistics(data.labels, data.volume)[1];
  EXPECT_EQ(only.voxels, 1u);
  EXPECT_EQ(only.deviation, 0.0);
  EXPECT_EQ(only.least, only.mean);
}

TEST(LabelStatistics, ALabelWithoutNumbersHasAVolumeAlone) {
  Random data(0.0);
  for (float& value : data.volume.voxels.as<float>()) value = std::numeric_limits<float>::quiet_NaN();
  const LabelStatistics first = labelStatistics(data.labels, data.volume)[0];
  EXPECT_GT(first.millilitres, 0.0);
  EXPECT_EQ(first.valued, 0u);
  EXPECT_EQ(first.mean, 0.0);
}

TEST(LabelStatistics, APlaceWithinIsTheVoxelNearestToTheCentre) {
  const Random data(0.0);
  const auto statistics = labelStatistics(data.labels, data.volume);
  const auto places = placesWithin(data.labels, statistics);
  ASSERT_EQ(places.size(), statistics.size());
  const Grid& grid = data.labels.grid;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (statistics[i].voxels == 0) continue;
    double least = 1e300;
    for (int z = 0; z < grid.dims.z; ++z)
      for (int y = 0; y < grid.dims.y; ++y)
        for (int x = 0; x < grid.dims.x; ++x)
          if (data.labels.value({x, y, z}) == statistics[i].label)
            least = std::min(least, glm::distance(glm::dvec3(grid.worldFromIndex() * glm::dvec4(x, y, z, 1.0)),
                                                  statistics[i].centre));
    // Rounding of a thousand millimetres in double precision.
    EXPECT_NEAR(glm::distance(places[i], statistics[i].centre), least, 1e-9) << statistics[i].label;
    const glm::dvec3 index(grid.indexFromWorld() * glm::dvec4(places[i], 1.0));
    EXPECT_LT(glm::distance(index, glm::round(index)), 1e-9) << "a voxel's centre";
    EXPECT_EQ(data.labels.value(glm::ivec3(glm::round(index))), statistics[i].label);
  }
}

}  // namespace
}  // namespace fenestra::label_statistics_test
