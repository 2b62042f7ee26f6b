// Thick slices against a dense computation of their own in double precision, and against closed forms.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "rendering/volume/ObliqueSlice.h"
#include "rendering/volume/Slab.h"
#include "tests/support/Scenes.h"

namespace fenestra::slab_test {
namespace {

using tests::gridOf;
using tests::obliqueGrid;
using tests::volumeOf;

constexpr SlabMode modes[] = {SlabMode::Maximum, SlabMode::Minimum, SlabMode::Mean};

Grid shearedGrid(glm::ivec3 dims) {
  Grid grid = gridOf(dims, {0.8, 1.1, 2.9}, {1200.0, -800.0, 3000.0});
  grid.direction = glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.4, glm::normalize(glm::dvec3(1.0, -2.0, 0.5))));
  grid.direction[2] = glm::normalize(grid.direction[2] + 0.4 * grid.direction[1] - 0.2 * grid.direction[0]);
  return grid;
}

PlaneAxes turned(const PlaneAxes& axes, double angle, glm::dvec3 about) {
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), angle, glm::normalize(about)));
  return {turn * axes.right, turn * axes.down, turn * axes.normal};
}

/// The index position of a point of the patient, by Cramer's rule. This and what follows share nothing with the project
/// but the values of the voxels and the meaning of a Grid's members.
glm::dvec3 positionOf(const Grid& grid, glm::dvec3 world) {
  const glm::dvec3 a = grid.direction[0] * grid.spacing.x, b = grid.direction[1] * grid.spacing.y,
                   c = grid.direction[2] * grid.spacing.z, v = world - grid.origin;
  const double whole = glm::dot(a, glm::cross(b, c));
  return {glm::dot(v, glm::cross(b, c)) / whole, glm::dot(a, glm::cross(v, c)) / whole,
          glm::dot(a, glm::cross(b, v)) / whole};
}

/// The trilinear field, whose outermost values go on outside.
double fieldAt(const Volume& volume, glm::dvec3 at) {
  int low[3], high[3];
  double share[3];
  for (int k = 0; k < 3; ++k) {
    const double held = std::clamp(at[k], 0.0, volume.grid.dims[k] - 1.0);
    low[k] = static_cast<int>(held);
    high[k] = std::min(low[k] + 1, volume.grid.dims[k] - 1);
    share[k] = held - low[k];
  }
  const auto along = [&](int y, int z) {
    return (1.0 - share[0]) * volume.value({low[0], y, z}) + share[0] * volume.value({high[0], y, z});
  };
  const auto across = [&](int z) { return (1.0 - share[1]) * along(low[1], z) + share[1] * along(high[1], z); };
  return (1.0 - share[2]) * across(low[2]) + share[2] * across(high[2]);
}

struct Dense {
  double maximum = tests::nan, minimum = tests::nan, mean = tests::nan;
  bool grazes = false;  ///< rounding decides whether the line is inside
  double of(SlabMode mode) const {
    return mode == SlabMode::Maximum ? maximum : mode == SlabMode::Minimum ? minimum : mean;
  }
};

/// At so many places of the part of the line that lies in the volume.
Dense dense(const Volume& volume, const SliceGeometry& geometry, int i, int j, int slice, double thickness,
            int steps = 1000) {
  const Grid& grid = volume.grid;
  const glm::dvec3 centre = geometry.worldFromPixel(i, j, slice);
  const glm::dvec3 normal = glm::normalize(glm::cross(geometry.right, geometry.down));
  const glm::dvec3 first = positionOf(grid, centre - 0.5 * thickness * normal);
  const glm::dvec3 whole = positionOf(grid, centre + 0.5 * thickness * normal) - first;
  double begin = 0.0, end = 1.0;
  bool grazes = false;
  for (int k = 0; k < 3; ++k)
    for (const double wall : {-0.5, grid.dims[k] - 0.5}) {
      const double inward = wall < 0.0 ? 1.0 : -1.0;
      // inward · (first + t · whole - wall) ≥ 0
      const double at = inward * (first[k] - wall), rise = inward * whole[k];
      // A direction of the grid, but for rounding.
      if (std::abs(rise) < 1e-9) {
        grazes = grazes || std::abs(at) < 1e-9;
        if (at < 0.0) return {.grazes = grazes};
        continue;
      }
      if (rise > 0.0) begin = std::max(begin, -at / rise);
      if (rise < 0.0) end = std::min(end, -at / rise);
    }
  if (!(begin < end)) return {.grazes = grazes};
  const auto at = [&](double step) { return fieldAt(volume, first + (begin + (end - begin) * step / steps) * whole); };
  Dense result{.grazes = grazes};
  double sum = 0.0;
  int greatest = 0, least = 0;
  for (int k = 0; k <= steps; ++k) {
    const double value = at(k);
    if (k == 0 || value > result.maximum) result.maximum = value, greatest = k;
    if (k == 0 || value < result.minimum) result.minimum = value, least = k;
    sum += k == 0 || k == steps ? 0.5 * value : value;
  }
  // The field has edges where cells meet, so that an extreme may be as sharp as a roof.
  for (int k = -500; k <= 500; ++k) {
    result.maximum = std::max(result.maximum, at(std::clamp(greatest + k / 500.0, 0.0, 1.0 * steps)));
    result.minimum = std::min(result.minimum, at(std::clamp(least + k / 500.0, 0.0, 1.0 * steps)));
  }
  result.mean = sum / steps;
  return result;
}

/// Compares every `stride`-th pixel; returns how many had a value.
int compare(const Volume& volume, const SliceGeometry& geometry, int slice, const Slab& slab, double tolerance,
            int stride = 1) {
  const std::vector<float> values = slabValues(volume, geometry, slice, slab);
  int compared = 0;
  for (int j = 0; j < geometry.height; j += stride)
    for (int i = 0; i < geometry.width; i += stride) {
      const Dense expected = dense(volume, geometry, i, j, slice, slab.thickness);
      const float value = values[static_cast<std::size_t>(j * geometry.width + i)];
      if (expected.grazes) continue;
      EXPECT_EQ(std::isnan(value), std::isnan(expected.mean)) << i << ", " << j;
      if (std::isnan(expected.mean)) continue;
      ++compared;
      EXPECT_NEAR(value, expected.of(slab.mode), tolerance)
          << "mode " << static_cast<int>(slab.mode) << " at " << i << ", " << j;
    }
  return compared;
}

/// Waves with noise: every cell has its own cubic, and many of those are greatest within.
template <class T>
std::shared_ptr<Volume> waves(const Grid& grid, double amplitude, double middle) {
  std::minstd_rand random(5);
  auto volume = volumeOf<T>(grid, [&](glm::ivec3 index) {
    const double wave = std::sin(0.7 * index.x) * std::cos(0.5 * index.y) * std::sin(0.9 * index.z + 0.3);
    return middle + amplitude * (0.7 * wave + 0.3 * (static_cast<double>(random() % 1000) / 500.0 - 1.0));
  });
  volume->modality = Modality::CT;
  return volume;
}

TEST(Slab, Thorough_AgreesWithADenseComputation) {
  for (const Grid& grid :
       {gridOf({20, 23, 17}, {0.7, 0.9, 2.5}), obliqueGrid({21, 18, 15}), shearedGrid({19, 22, 13})}) {
    const auto volume = waves<std::int16_t>(grid, 300.0, 100.0);
    int compared = 0;
    for (const SlicePlane plane : {SlicePlane::Axial, SlicePlane::Sagittal, SlicePlane::Coronal})
      for (const double angle : {0.0, 0.6, 2.1}) {
        const PlaneAxes axes = turned(planeAxes(grid, plane), angle, {0.3, 1.0, -0.6});
        const SliceGeometry geometry = obliqueGeometry(grid, plane, axes, grid.centre(), 1.3);
        for (const SlabMode mode : modes)
          // The dense computation is exact to hundredths; 0.6 of a stored step is what a picture may be off.
          for (const double thickness : {1.0, 10.0})
            compared += compare(*volume, geometry, geometry.count / 2, {thickness, mode}, 0.6, 3);
      }
    EXPECT_GT(compared, 1500);
  }
}

TEST(Slab, Thorough_LongLinesStayAsExact) {
  // 600 voxels, in many pieces.
  const Grid grid = gridOf({6, 5, 600}, {1.0, 1.0, 0.5}, {0.0, 0.0, -900.0});
  const auto volume = waves<std::int16_t>(grid, 30000.0, 0.0);
  PlaneAxes axes = planeAxes(grid, SlicePlane::Axial);
  axes = turned(axes, 0.004, {1.0, 0.6, 0.0});
  const SliceGeometry geometry = obliqueGeometry(grid, SlicePlane::Axial, axes, grid.centre(), 0.7);
  const int slice = geometry.count / 2;
  for (const SlabMode mode : modes) {
    const std::vector<float> values = slabValues(*volume, geometry, slice, {400.0, mode});
    int compared = 0;
    for (int j = 2; j < geometry.height; j += 3)
      for (int i = 2; i < geometry.width; i += 3) {
        const Dense expected = dense(*volume, geometry, i, j, slice, 400.0, 400000);
        if (std::isnan(expected.mean)) continue;
        ++compared;
        EXPECT_NEAR(values[static_cast<std::size_t>(j * geometry.width + i)], expected.of(mode), 0.6);
      }
    EXPECT_GE(compared, 4);
  }
}

template <class T>
class SlabOf : public testing::Test {};
using Types =
    testing::Types<std::uint8_t, std::int8_t, std::uint16_t, std::int16_t, std::uint32_t, std::int32_t, float, double>;
TYPED_TEST_SUITE(SlabOf, Types);

TYPED_TEST(SlabOf, AllTypesAndSlopes) {
  using T = TypeParam;
  const Grid grid = obliqueGrid({9, 11, 8});
  const double middle = std::is_signed_v<T> ? 0.0 : sizeof(T) == 1 ? 127.0 : 40000.0;
  const auto volume = waves<T>(grid, sizeof(T) == 1 ? 120.0 : 20000.0, middle);
  const PlaneAxes axes = turned(planeAxes(grid, SlicePlane::Coronal), 0.5, {1.0, 0.2, 0.1});
  const SliceGeometry geometry = obliqueGeometry(grid, SlicePlane::Coronal, axes, grid.centre(), 1.0);
  // A negative slope turns the maximum of the stored values into the minimum.
  for (const double slope : {1.0, -0.5}) {
    volume->slope = slope;
    volume->intercept = -7.0;
    for (const SlabMode mode : modes)
      EXPECT_GT(compare(*volume, geometry, geometry.count / 2, {4.0, mode}, 0.6 * std::abs(slope), 2), 30);
  }
}

TEST(Slab, OfARampIsTheRampsEnds) {
  // Along a line, a linear field is greatest at its end and its mean is that of the slice.
  const Grid grid = gridOf({40, 40, 40});
  const auto volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) { return 20 * i.x - 10 * i.y + 30 * i.z; });
  const PlaneAxes axes = turned(planeAxes(grid, SlicePlane::Axial), 0.7, {1.0, 0.4, 0.2});
  const SliceGeometry geometry = obliqueGeometry(grid, SlicePlane::Axial, axes, {19.5, 19.5, 19.5}, 1.0);
  const glm::dvec3 through = geometry.pixelFromWorld({19.5, 19.5, 19.5});
  const int slice = static_cast<int>(std::lround(through.z));
  const glm::dvec3 slope(20.0, -10.0, 30.0);
  const double perMm = std::abs(glm::dot(slope, axes.normal));
  for (const SlabMode mode : modes) {
    const std::vector<float> values = slabValues(*volume, geometry, slice, {8.0, mode});
    for (int j = -8; j <= 8; ++j)
      for (int i = -8; i <= 8; ++i) {
        const auto column = static_cast<int>(std::lround(through.x)) + i,
                   row = static_cast<int>(std::lround(through.y)) + j;
        const double middle = glm::dot(slope, geometry.worldFromPixel(column, row, slice));
        const double expected =
            mode == SlabMode::Mean ? middle : middle + (mode == SlabMode::Maximum ? 4.0 : -4.0) * perMm;
        // float32 holds a thousand to 1e-4.
        EXPECT_NEAR(values[static_cast<std::size_t>(row * geometry.width + column)], expected, 2e-3);
      }
  }
}

TEST(Slab, OfABallIsItsDepth) {
  // A cone, 1000 - 40·distance to its tip: its maximum over a slab that holds the tip is that at the nearest point of
  // the line, and its minimum that at the farther end.
  const glm::dvec3 tip(30.3, 29.6, 30.1);
  const Grid grid = gridOf({61, 61, 61});
  const auto volume =
      volumeOf<float>(grid, [&](glm::ivec3 i) { return 1000.0 - 40.0 * glm::distance(glm::dvec3(i), tip); });
  const PlaneAxes axes = turned(planeAxes(grid, SlicePlane::Sagittal), 0.9, {0.1, 1.0, 0.5});
  const SliceGeometry geometry = obliqueGeometry(grid, SlicePlane::Sagittal, axes, tip, 1.0);
  const glm::dvec3 middle = geometry.pixelFromWorld(tip);
  const auto at = [&](const std::vector<float>& values, int i, int j) {
    const int column = static_cast<int>(std::lround(middle.x)) + i, row = static_cast<int>(std::lround(middle.y)) + j;
    return values[static_cast<std::size_t>(row * geometry.width + column)];
  };
  const int slice = static_cast<int>(std::lround(middle.z));
  const std::vector<float> maximum = slabValues(*volume, geometry, slice, {12.0, SlabMode::Maximum});
  const std::vector<float> minimum = slabValues(*volume, geometry, slice, {12.0, SlabMode::Minimum});
  const std::vector<float> mean = slabValues(*volume, geometry, slice, {12.0, SlabMode::Mean});
  for (int j = -15; j <= 15; j += 3)
    for (int i = -15; i <= 15; i += 3) {
      const double across = std::hypot(i, j), end = std::hypot(across, 6.0);
      if (across < 4.0) continue;
      // Trilinear between the voxels of a cone stays within 40/8·(1/r + 1/r) of it, below 2.5 from r = 4 mm on.
      EXPECT_NEAR(at(maximum, i, j), 1000.0 - 40.0 * across, 2.5);
      EXPECT_NEAR(at(minimum, i, j), 1000.0 - 40.0 * end, 2.5);
      // The mean distance to a point `across` beside the middle of a line of 12 mm.
      const double distance = 0.5 * (end + across * across / 6.0 * std::asinh(6.0 / across));
      EXPECT_NEAR(at(mean, i, j), 1000.0 - 40.0 * distance, 2.5);
    }
}

TEST(Slab, OutsideIsNoNumberAndDoesNotCount) {
  const Grid grid = gridOf({10, 10, 10});
  const auto volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) { return 100 * i.z; });
  SliceGeometry geometry = sliceGeometry(grid, SlicePlane::Axial);
  geometry.origin.x -= 2.0;
  geometry.width += 4;
  for (const SlabMode mode : modes) {
    const std::vector<float> values = slabValues(*volume, geometry, 9, {5.0, mode});
    for (int i = 0; i < geometry.width; ++i) {
      const float value = values[static_cast<std::size_t>(5 * geometry.width + i)];
      if (i < 2 || i >= 12) {
        EXPECT_TRUE(std::isnan(value));
        continue;
      }
      // From z = 6.5 to the box's end at 9.5; the last half voxel repeats the last centre's 900.
      const double expected = mode == SlabMode::Maximum   ? 900.0
                              : mode == SlabMode::Minimum ? 650.0
                                                          : (2.5 * 775.0 + 0.5 * 900.0) / 3.0;
      EXPECT_NEAR(value, expected, 1e-3);
    }
  }
}

TEST(Slab, ReachesInFromASliceOutside) {
  const Grid grid = gridOf({10, 10, 10});
  const auto volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) { return 100 * i.z; });
  const SliceGeometry geometry = sliceGeometry(grid, SlicePlane::Axial);
  EXPECT_NEAR(slabValues(*volume, geometry, -2, {6.0, SlabMode::Maximum})[0], 100.0, 1e-3);
  EXPECT_TRUE(std::isnan(slabValues(*volume, geometry, -2, {2.0, SlabMode::Maximum})[0]));
}

TEST(Slab, CellsWithoutNumbersDoNotCount) {
  const Grid grid = gridOf({4, 4, 12});
  const auto volume = volumeOf<float>(grid, [](glm::ivec3 i) { return i.z == 6 ? tests::nan : 10.0 * i.z; });
  const SliceGeometry geometry = sliceGeometry(grid, SlicePlane::Axial);
  EXPECT_NEAR(slabValues(*volume, geometry, 5, {6.0, SlabMode::Maximum})[5], 80.0, 1e-3);
  // From 2 to 5 and from 7 to 8.
  EXPECT_NEAR(slabValues(*volume, geometry, 5, {6.0, SlabMode::Mean})[5], (3.0 * 35.0 + 75.0) / 4.0, 1e-3);
  const auto none = volumeOf<float>(grid, [](glm::ivec3) { return tests::nan; });
  for (const SlabMode mode : modes) EXPECT_TRUE(std::isnan(slabValues(*none, geometry, 5, {6.0, mode})[5]));
}

TEST(Slab, ThinVolumes) {
  // Axes of one voxel, the first among them, which the kernel reads in pairs.
  for (const glm::ivec3 dims : {glm::ivec3(1, 7, 6), glm::ivec3(8, 1, 6), glm::ivec3(8, 7, 1), glm::ivec3(1, 1, 1)}) {
    const auto volume = waves<std::int16_t>(gridOf(dims, {1.0, 1.5, 2.0}), 1000.0, 0.0);
    const PlaneAxes axes = turned(planeAxes(volume->grid, SlicePlane::Axial), 0.3, {1.0, 0.7, 0.0});
    const SliceGeometry geometry = obliqueGeometry(volume->grid, SlicePlane::Axial, axes, volume->grid.centre(), 0.5);
    for (const SlabMode mode : modes) EXPECT_GT(compare(*volume, geometry, geometry.count / 2, {1.0, mode}, 0.6), 0);
  }
}

TEST(Slab, ThicknessZeroIsTheSlice) {
  const auto volume = waves<std::int16_t>(obliqueGrid({12, 13, 11}), 500.0, 0.0);
  const SliceGeometry geometry =
      obliqueGeometry(volume->grid, SlicePlane::Axial,
                      turned(planeAxes(volume->grid, SlicePlane::Axial), 0.4, {1, 1, 0}), volume->grid.centre());
  const std::vector<float> slice = sliceValues(*volume, geometry, 4);
  for (const SlabMode mode : modes) {
    const std::vector<float> slab = slabValues(*volume, geometry, 4, {0.0, mode});
    for (std::size_t i = 0; i < slice.size(); ++i)
      EXPECT_TRUE(slab[i] == slice[i] || (std::isnan(slab[i]) && std::isnan(slice[i])));
  }
}

TEST(Slab, IsPerpendicularWhereTheGridIsSheared) {
  const Grid grid = shearedGrid({19, 22, 13});
  const auto volume = waves<std::int16_t>(grid, 300.0, 100.0);
  for (const SlicePlane plane : {SlicePlane::Axial, SlicePlane::Sagittal, SlicePlane::Coronal}) {
    const SliceGeometry geometry = sliceGeometry(grid, plane);
    for (const SlabMode mode : modes)
      EXPECT_GT(compare(*volume, geometry, geometry.count / 2, {6.0, mode}, 0.6, 2), 50);
  }
}

TEST(Slab, LargePixelsAndHugeSlabs) {
  // Lines far from one another, and a slab far beyond the volume.
  const Grid grid = obliqueGrid({40, 30, 35});
  const auto volume = waves<std::int16_t>(grid, 300.0, 100.0);
  const PlaneAxes axes = turned(planeAxes(grid, SlicePlane::Axial), 0.6, {0.3, 1.0, -0.6});
  const SliceGeometry geometry = obliqueGeometry(grid, SlicePlane::Axial, axes, grid.centre(), 11.0);
  const int slice = geometry.count / 2;
  const std::vector<float> values = slabValues(*volume, geometry, slice, {1e9, SlabMode::Maximum});
  int met = 0;
  for (int j = 0; j < geometry.height; ++j)
    for (int i = 0; i < geometry.width; ++i) {
      const Dense expected = dense(*volume, geometry, i, j, slice, 200.0, 10000);
      if (std::isnan(expected.maximum)) continue;
      ++met;
      EXPECT_NEAR(values[static_cast<std::size_t>(j * geometry.width + i)], expected.maximum, 0.6);
    }
  EXPECT_GT(met, 10);
}

}  // namespace
}  // namespace fenestra::slab_test
