#include "rendering/volume/Slice.h"

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

namespace fenestra::sliceTest {
namespace {

struct Case {
  std::string name;
  Grid grid;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

glm::dmat3 turned(double degrees, glm::dvec3 axis) {
  return glm::dmat3(glm::rotate(glm::dmat4(1.0), glm::radians(degrees), axis));
}

std::vector<Case> grids() {
  const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const double tilt = glm::radians(18.5);
  const Grid base{{7, 6, 5}, {0.8, 1.1, 2.5}, {-20.0, 13.0, 400.0}, glm::dmat3(1.0)};
  const auto with = [&](glm::dmat3 direction) {
    Grid grid = base;
    grid.direction = direction;
    return grid;
  };
  std::vector<Case> cases{
      {"Lps", base},
      {"Las", with({x, -y, z})},
      {"Ras", with({-x, -y, z})},
      {"AllFlipped", with({-x, -y, -z})},
      {"SagittallyAcquired", with({y, -z, x})},
      {"CoronallyAcquired", with({x, -z, y})},
      {"Oblique", with(turned(23.0, glm::normalize(glm::dvec3(1.0, -0.6, 0.4))))},
      {"ObliqueFlipped", with(turned(-31.0, glm::normalize(glm::dvec3(0.3, 0.7, -0.2))) * glm::dmat3(y, -z, x))},
      {"TiltedGantry", with({x, glm::dvec3(0.0, std::cos(tilt), -std::sin(tilt)), z})},
      {"TiltedGantryOtherWay", with({x, glm::dvec3(0.0, std::cos(tilt), std::sin(tilt)), -z})},
  };
  Grid single = base;
  single.dims = {7, 6, 1};
  cases.push_back({"SingleSlice", single});
  Grid voxel = base;
  voxel.dims = {1, 1, 1};
  cases.push_back({"SingleVoxel", voxel});
  Grid distant = with(turned(10.0, x));
  distant.spacing = {0.05, 0.05, 10.0};
  distant.origin = {1e6, -1e6, 1e6};
  cases.push_back({"MetresAway", distant});
  return cases;
}

/// Every voxel has a value of its own.
Volume numbered(const Grid& grid) {
  Volume volume;
  volume.grid = grid;
  volume.voxels = Voxels(ScalarType::Int16, grid.voxelCount());
  auto scalars = volume.voxels.as<std::int16_t>();
  for (std::size_t i = 0; i < scalars.size(); ++i) scalars[i] = static_cast<std::int16_t>(i);
  volume.slope = 2.0;
  volume.intercept = -100.0;
  volume.computeRange();
  return volume;
}

constexpr SlicePlane planes[] = {SlicePlane::Axial, SlicePlane::Sagittal, SlicePlane::Coronal};

class SliceOnGrid : public ::testing::TestWithParam<Case> {};

TEST_P(SliceOnGrid, FollowsRadiologicalConvention) {
  const glm::dvec3 left(1, 0, 0), posterior(0, 1, 0), superior(0, 0, 1);
  const SliceGeometry axial = sliceGeometry(GetParam().grid, SlicePlane::Axial);
  EXPECT_GT(glm::dot(axial.right, left), 0.0);
  EXPECT_GT(glm::dot(axial.down, posterior), 0.0);
  EXPECT_GT(glm::dot(axial.normal, superior), 0.0);
  const SliceGeometry sagittal = sliceGeometry(GetParam().grid, SlicePlane::Sagittal);
  EXPECT_GT(glm::dot(sagittal.right, posterior), 0.0);
  EXPECT_LT(glm::dot(sagittal.down, superior), 0.0);
  EXPECT_GT(glm::dot(sagittal.normal, left), 0.0);
  const SliceGeometry coronal = sliceGeometry(GetParam().grid, SlicePlane::Coronal);
  EXPECT_GT(glm::dot(coronal.right, left), 0.0);
  EXPECT_LT(glm::dot(coronal.down, superior), 0.0);
  EXPECT_GT(glm::dot(coronal.normal, posterior), 0.0);
}

TEST_P(SliceOnGrid, PictureSidesAreOrthogonal) {
  for (const SlicePlane plane : planes) {
    const SliceGeometry g = sliceGeometry(GetParam().grid, plane);
    EXPECT_NEAR(glm::dot(glm::normalize(g.right), glm::normalize(g.down)), 0.0, 1e-12);
  }
}

TEST_P(SliceOnGrid, ShowsEveryVoxelAtItsPlaceInThePatient) {
  const Volume volume = numbered(GetParam().grid);
  for (const SlicePlane plane : planes) {
    const SliceGeometry g = sliceGeometry(volume.grid, plane);
    std::size_t inside = 0;
    for (int k = 0; k < g.count; ++k) {
      const std::vector<float> values = sliceValues(volume, g, k);
      ASSERT_EQ(values.size(), static_cast<std::size_t>(g.width) * static_cast<std::size_t>(g.height));
      for (int j = 0; j < g.height; ++j)
        for (int i = 0; i < g.width; ++i) {
          const float shown = values[static_cast<std::size_t>(j * g.width + i)];
          if (std::isnan(shown)) continue;
          ++inside;
          const glm::dvec3 index(volume.grid.indexFromWorld() * glm::dvec4(g.worldFromPixel(i, j, k), 1.0));
          // Float rounding of values up to 320, and steps of 84 a voxel times the 2e-9 voxel by which a world position
          // 1e6 mm away rounds.
          EXPECT_NEAR(shown, volume.sample(index), 1e-4);
        }
    }
    EXPECT_GE(inside, volume.grid.voxelCount());
  }
}

TEST_P(SliceOnGrid, CoversTheVolume) {
  const Grid& grid = GetParam().grid;
  for (const SlicePlane plane : planes) {
    const SliceGeometry g = sliceGeometry(grid, plane);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 index((corner & 1) ? grid.dims.x - 1 : 0, (corner & 2) ? grid.dims.y - 1 : 0,
                             (corner & 4) ? grid.dims.z - 1 : 0);
      const glm::dvec3 pixel = g.pixelFromWorld(glm::dvec3(grid.worldFromIndex() * glm::dvec4(index, 1.0)));
      // Positions at 1e6 mm are exact to 1e-10 mm, 2e-9 of a 0.05 mm voxel.
      constexpr double rounding = 1e-7;
      EXPECT_GE(pixel.x, -rounding);
      EXPECT_LE(pixel.x, g.width - 1 + rounding);
      EXPECT_GE(pixel.y, -rounding);
      EXPECT_LE(pixel.y, g.height - 1 + rounding);
      EXPECT_NEAR(pixel.z, std::round(pixel.z), rounding);
      EXPECT_GE(pixel.z, -rounding);
      EXPECT_LE(pixel.z, g.count - 1 + rounding);
    }
  }
}

TEST_P(SliceOnGrid, FindsSlicesByPatientCoordinate) {
  for (const SlicePlane plane : planes) {
    const SliceGeometry g = sliceGeometry(GetParam().grid, plane);
    const int along = plane == SlicePlane::Axial ? 2 : plane == SlicePlane::Sagittal ? 0 : 1;
    for (int k = 0; k < g.count; ++k)
      EXPECT_EQ(g.sliceAt(g.worldFromPixel(0.5 * (g.width - 1), 0.5 * (g.height - 1), k)[along]), k);
    EXPECT_EQ(g.sliceAt(-1e12), 0);
    EXPECT_EQ(g.sliceAt(1e12), g.count - 1);
    EXPECT_EQ(g.sliceAt(std::numeric_limits<double>::quiet_NaN()), 0);
  }
}

TEST_P(SliceOnGrid, LabelsLieUnderTheirVoxels) {
  const Volume volume = numbered(GetParam().grid);
  LabelMap labels;
  labels.grid = volume.grid;
  labels.voxels = Voxels(ScalarType::UInt16, volume.grid.voxelCount());
  auto scalars = labels.voxels.as<std::uint16_t>();
  for (std::size_t i = 0; i < scalars.size(); ++i) scalars[i] = static_cast<std::uint16_t>(i + 1);
  for (const SlicePlane plane : planes) {
    const SliceGeometry g = sliceGeometry(volume.grid, plane);
    const std::vector<std::uint16_t> shown = sliceLabels(labels, g, g.count / 2);
    for (int j = 0; j < g.height; ++j)
      for (int i = 0; i < g.width; ++i) {
        const glm::dvec3 position(volume.grid.indexFromWorld() * glm::dvec4(g.worldFromPixel(i, j, g.count / 2), 1.0));
        const glm::dvec3 fraction = glm::abs(position - glm::round(position));
        if (std::max({fraction.x, fraction.y, fraction.z}) > 0.49) continue;  // a tie between two voxels
        const glm::ivec3 index(glm::round(position));
        const int expected = volume.grid.contains(index) ? static_cast<int>(volume.grid.offset(index)) + 1 : 0;
        EXPECT_EQ(shown[static_cast<std::size_t>(j * g.width + i)], expected);
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Grids, SliceOnGrid, ::testing::ValuesIn(grids()),
                         [](const auto& instance) { return instance.param.name; });

TEST(Slice, UprightVolumeIsShownVoxelForVoxel) {
  const Volume volume = numbered({{4, 3, 2}, {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}, glm::dmat3(1.0)});
  const std::vector<float> axial = sliceValues(volume, sliceGeometry(volume.grid, SlicePlane::Axial), 1);
  ASSERT_EQ(axial.size(), 12u);
  for (std::size_t i = 0; i < axial.size(); ++i) EXPECT_EQ(axial[i], 2.0f * static_cast<float>(i + 12) - 100.0f);
  // Coronal: superior is up, so the first row is the last slice.
  const std::vector<float> coronal = sliceValues(volume, sliceGeometry(volume.grid, SlicePlane::Coronal), 0);
  EXPECT_EQ(coronal, (std::vector<float>{-76, -74, -72, -70, -100, -98, -96, -94}));
}

TEST(Slice, TiltedGantryLeavesCornersEmpty) {
  const double tilt = glm::radians(30.0);
  Grid grid{{3, 20, 10}, {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}, glm::dmat3(1.0)};
  grid.direction[1] = {0.0, std::cos(tilt), -std::sin(tilt)};
  const Volume volume = numbered(grid);
  const SliceGeometry g = sliceGeometry(grid, SlicePlane::Sagittal);
  // The table's travel stays vertical; 19 steps along y sink by 19·sin 30° = 9.5 rows.
  EXPECT_EQ(g.width, 20);
  EXPECT_EQ(g.height, 20);
  EXPECT_NEAR(glm::dot(glm::normalize(g.down), glm::dvec3(0, 0, -1)), 1.0, 1e-12);
  const std::vector<float> values = sliceValues(volume, g, 1);
  EXPECT_FALSE(std::isnan(values[0]));                                 // anterior, top
  EXPECT_TRUE(std::isnan(values[19]));                                 // posterior, top: the gantry leans away
  EXPECT_TRUE(std::isnan(values[static_cast<std::size_t>(19 * 20)]));  // anterior, bottom
}

TEST(Slice, WindowMapsItsEndsToBlackAndWhite) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const std::vector<float> values{-1000, -100, 50, 200, 3000, nan, inf, -inf};
  EXPECT_EQ(windowed(values, {300.0, 50.0}), (std::vector<std::uint8_t>{0, 0, 128, 255, 255, 0, 255, 0}));
  EXPECT_EQ(windowed(values, {300.0, 50.0}, true), (std::vector<std::uint8_t>{255, 255, 128, 0, 0, 0, 0, 255}));
  EXPECT_EQ(windowed({49.0f, 51.0f}, {0.0, 50.0}), (std::vector<std::uint8_t>{0, 255}));
}

TEST(Slice, LettersNameThePatientsSides) {
  EXPECT_EQ(orientationLetters({1, 0, 0}), "L");
  EXPECT_EQ(orientationLetters({-2, 0, 0}), "R");
  EXPECT_EQ(orientationLetters({0, -1, 0}), "A");
  EXPECT_EQ(orientationLetters({0, 0, 1}), "S");
  EXPECT_EQ(orientationLetters({-0.5, 0.8, 0.1}), "PR");
  EXPECT_EQ(orientationLetters({0.5, -0.6, -0.7}), "IAL");
  EXPECT_EQ(orientationLetters({0, 0, 0}), "");
}

}  // namespace
}  // namespace fenestra::sliceTest
