// Measures against closed forms, on volumes as scanners store them: axial CT, sagittal and oblique MR, a NIfTI with
// flipped axes, and a CT with a tilted gantry.

#include <cmath>

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rendering/volume/SliceMeasure.h"

namespace fenestra::sliceMeasureTest {
namespace {

struct Scan {
  const char* name;
  Grid grid;
};

glm::dmat3 columns(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) { return {a, b, c}; }

const Scan scans[] = {
    {"axial CT", {{40, 32, 20}, {0.7, 0.7, 2.5}, {-14.0, -11.0, 100.0}, glm::dmat3(1.0)}},
    {"sagittal MR", {{32, 30, 12}, {0.9, 0.9, 4.0}, {20.0, -15.0, 30.0}, columns({0, 1, 0}, {0, 0, -1}, {-1, 0, 0})}},
    {"oblique MR",
     {{36, 34, 14},
      {0.8, 1.1, 3.3},
      {5.0, -60.0, 12.0},
      glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.4, glm::normalize(glm::dvec3(1.0, 0.3, -0.2))))}},
    {"flipped NIfTI", {{30, 28, 18}, {1.5, 1.5, 2.0}, {45.0, 40.0, -7.0}, columns({-1, 0, 0}, {0, -1, 0}, {0, 0, 1})}},
    {"tilted CT",
     {{32, 30, 16},
      {0.6, 0.6, 3.0},
      {-9.0, -9.0, 50.0},
      columns({1, 0, 0}, {0, std::cos(0.32), std::sin(0.32)}, {0, 0, 1})}},
};

constexpr SlicePlane planes[] = {SlicePlane::Axial, SlicePlane::Sagittal, SlicePlane::Coronal};

/// Real values that grow linearly through the patient: HU per mm along L, P and S.
const glm::dvec3 gradient(3.0, -5.0, 2.0);
constexpr double offset = -300.0;

Volume linearVolume(const Grid& grid) {
  Volume volume;
  volume.grid = grid;
  volume.voxels = Voxels(ScalarType::Float64, grid.voxelCount());
  volume.slope = 0.5;
  volume.intercept = -1024.0;
  auto stored = volume.voxels.as<double>();
  for (int z = 0; z < grid.dims.z; ++z)
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x) {
        const glm::dvec3 world(grid.worldFromIndex() * glm::dvec4(x, y, z, 1.0));
        stored[grid.offset({x, y, z})] = (glm::dot(gradient, world) + offset + 1024.0) / 0.5;
      }
  volume.computeRange();
  return volume;
}

Measure onSlice(const SliceGeometry& geometry, MeasureKind kind, int slice, std::vector<glm::dvec2> pixels) {
  Measure measure{kind, {}, glm::normalize(geometry.right), glm::normalize(geometry.down)};
  for (const glm::dvec2 pixel : pixels) measure.points.push_back(geometry.worldFromPixel(pixel.x, pixel.y, slice));
  return measure;
}

/// Runs `check` for every plane of every scan.
template <class F>
void forEachPlane(F&& check) {
  for (const Scan& scan : scans)
    for (const SlicePlane plane : planes) {
      SCOPED_TRACE(std::string(scan.name) + ", plane " + std::to_string(static_cast<int>(plane)));
      check(scan, sliceGeometry(scan.grid, plane));
    }
}

TEST(Measure, LengthsAndAnglesAreThoseOfThePatient) {
  forEachPlane([](const Scan& scan, const SliceGeometry& geometry) {
    const Volume volume = linearVolume(scan.grid);
    // 3 pixels across and 4 down, whose sides are at right angles on every slice.
    const double across = 3.0 * glm::length(geometry.right), down = 4.0 * glm::length(geometry.down);
    const Measure line = onSlice(geometry, MeasureKind::Distance, 5, {{4.25, 6.5}, {7.25, 10.5}});
    EXPECT_NEAR(valuesOf(line, volume).length.value(), std::hypot(across, down), 1e-9);
    EXPECT_FALSE(valuesOf(line, volume).area);

    const Measure corner = onSlice(geometry, MeasureKind::Angle, 5, {{9.0, 2.0}, {2.0, 2.0}, {2.0, 8.0}});
    EXPECT_NEAR(valuesOf(corner, volume).angle.value(), 90.0, 1e-9);
    const Measure diagonal = onSlice(geometry, MeasureKind::Angle, 5, {{9.0, 2.0}, {2.0, 2.0}, {5.0, 6.0}});
    EXPECT_NEAR(valuesOf(diagonal, volume).angle.value(), glm::degrees(std::atan2(down, across)), 1e-9);
  });
}

TEST(Measure, AnglesKeepTheirDigitsNearZeroAndStraight) {
  const SliceGeometry geometry = sliceGeometry(scans[0].grid, SlicePlane::Axial);
  const Volume volume = linearVolume(scans[0].grid);
  for (const double degrees : {1e-5, 0.01, 60.0, 179.99, 180.0}) {
    const double turn = glm::radians(degrees);
    Measure angle = onSlice(geometry, MeasureKind::Angle, 3, {{10, 10}, {10, 10}, {10, 10}});
    angle.points[0] += 10.0 * angle.right;
    angle.points[2] += 8.0 * (std::cos(turn) * angle.right + std::sin(turn) * angle.down);
    EXPECT_NEAR(valuesOf(angle, volume).angle.value(), degrees, 1e-9);
  }
}

TEST(Measure, ARectanglesValuesAreTheClosedFormOfALinearField) {
  forEachPlane([](const Scan& scan, const SliceGeometry& geometry) {
    const Volume volume = linearVolume(scan.grid);
    // In the middle of the picture: a sheared plane's picture has corners outside the volume.
    const int i = geometry.width / 2 - 3, j = geometry.height / 2 - 2, slice = geometry.count / 2;
    constexpr int columnCount = 6, rowCount = 5;
    const Measure box = onSlice(geometry, MeasureKind::Rectangle, slice,
                                {{i - 0.4, j - 0.3}, {i + columnCount - 0.6, j + rowCount - 0.7}});
    const MeasureValues values = valuesOf(box, volume);
    ASSERT_TRUE(values.region);
    EXPECT_EQ(values.region->count, std::size_t{columnCount * rowCount});
    const double width = (columnCount - 0.2) * glm::length(geometry.right);
    const double height = (rowCount - 0.4) * glm::length(geometry.down);
    EXPECT_NEAR(values.area.value(), width * height, 1e-9);

    const glm::dvec3 middle = geometry.worldFromPixel(i + 0.5 * (columnCount - 1), j + 0.5 * (rowCount - 1), slice);
    const double a = glm::dot(gradient, geometry.right), b = glm::dot(gradient, geometry.down);
    // Interpolation of a linear field is exact up to rounding.
    EXPECT_NEAR(values.region->mean, glm::dot(gradient, middle) + offset, 1e-8);
    const double reach = 0.5 * (std::abs(a) * (columnCount - 1) + std::abs(b) * (rowCount - 1));
    EXPECT_NEAR(values.region->least, values.region->mean - reach, 1e-8);
    EXPECT_NEAR(values.region->greatest, values.region->mean + reach, 1e-8);
    // n whole numbers in a row have the variance (n² - 1) / 12.
    const double variance = (a * a * (columnCount * columnCount - 1) + b * b * (rowCount * rowCount - 1)) / 12.0;
    const double n = columnCount * rowCount;
    EXPECT_NEAR(values.region->deviation, std::sqrt(variance * n / (n - 1.0)), 1e-8);
  });
}

TEST(Measure, AnEllipsesAreaAndPixelsAreThoseOfItsEquation) {
  forEachPlane([](const Scan& scan, const SliceGeometry& geometry) {
    const Volume volume = linearVolume(scan.grid);
    const glm::dvec2 middle(geometry.width / 2, geometry.height / 2), half(2.5, 1.7);  // below the thinnest stack
    const int slice = geometry.count / 2;
    const MeasureValues values =
        valuesOf(onSlice(geometry, MeasureKind::Ellipse, slice, {middle - half, middle + half}), volume);
    const double pixel = glm::length(geometry.right) * glm::length(geometry.down);
    EXPECT_NEAR(values.area.value(), glm::pi<double>() * half.x * half.y * pixel, 1e-9);
    std::size_t inside = 0;
    for (int y = -3; y <= 3; ++y)
      for (int x = -3; x <= 3; ++x) inside += std::pow(x / half.x, 2) + std::pow(y / half.y, 2) <= 1.0;
    ASSERT_TRUE(values.region);
    EXPECT_EQ(values.region->count, inside);
    // The pixels are symmetric about the middle.
    EXPECT_NEAR(values.region->mean, glm::dot(gradient, geometry.worldFromPixel(middle.x, middle.y, slice)) + offset,
                1e-8);
  });
}

TEST(Measure, LiesOnTheSlicesWithinHalfASliceOfItsPlaneOnly) {
  forEachPlane([](const Scan& scan, const SliceGeometry& geometry) {
    const Measure line = onSlice(geometry, MeasureKind::Distance, 6, {{3.0, 4.0}, {9.0, 5.0}});
    EXPECT_EQ(sliceOf(line, geometry), 6);
    EXPECT_EQ(sliceOf(movedBy(line, 0.49 * geometry.normal), geometry), 6);
    EXPECT_EQ(sliceOf(movedBy(line, 0.51 * geometry.normal), geometry), 7);
    EXPECT_EQ(sliceOf(movedBy(line, -6.51 * geometry.normal), geometry), std::nullopt);
    for (const SlicePlane other : planes)
      if (other != geometry.plane) {
        EXPECT_EQ(sliceOf(line, sliceGeometry(scan.grid, other)), std::nullopt);
      }
  });
}

TEST(Measure, PartsOutsideTheVolumeDoNotCount) {
  const Volume volume = linearVolume(scans[0].grid);
  const SliceGeometry geometry = sliceGeometry(volume.grid, SlicePlane::Axial);
  const Measure over = onSlice(geometry, MeasureKind::Rectangle, 2, {{-3.4, -7.4}, {1.4, 0.4}});
  EXPECT_EQ(valuesOf(over, volume).region.value().count, 2u);
  const Measure between = onSlice(geometry, MeasureKind::Ellipse, 2, {{4.1, 4.1}, {4.9, 4.9}});
  EXPECT_FALSE(valuesOf(between, volume).region) << "no pixel centre inside";
  EXPECT_GT(valuesOf(between, volume).area.value(), 0.0);
  const Measure beyond = onSlice(geometry, MeasureKind::Rectangle, 2, {{400.0, 400.0}, {500.0, 500.0}});
  EXPECT_FALSE(valuesOf(beyond, volume).region);
}

TEST(Measure, HandlesMoveWhatTheyMark) {
  forEachPlane([](const Scan&, const SliceGeometry& geometry) {
    for (const MeasureKind kind : {MeasureKind::Rectangle, MeasureKind::Ellipse}) {
      const Measure before = onSlice(geometry, kind, 4, {{2.0, 3.0}, {8.0, 7.0}});
      const std::vector<glm::dvec3> handles = handlesOf(before);
      ASSERT_EQ(handles.size(), 4u);
      for (std::size_t handle = 0; handle < 4; ++handle) {
        const glm::dvec3 to = handles[handle] + 0.7 * geometry.right - 0.4 * geometry.down;
        const Measure after = withHandleAt(before, handle, to);
        // An ellipse's handle stays in the middle of its side.
        const glm::dvec3 allowed = kind == MeasureKind::Rectangle ? to - handles[handle]
                                   : handle % 2 == 0              ? -0.4 * geometry.down
                                                                  : 0.7 * geometry.right;
        EXPECT_LT(glm::distance(handlesOf(after)[handle], handles[handle] + allowed), 1e-9) << handle;
        // The opposite one stays where it is.
        const glm::dvec3 opposite = handlesOf(after)[(handle + 2) % 4] - handles[(handle + 2) % 4];
        EXPECT_LT(glm::length(opposite), 1e-9) << handle;
      }
    }
    const Measure angle = onSlice(geometry, MeasureKind::Angle, 4, {{2.0, 3.0}, {8.0, 7.0}, {1.0, 1.0}});
    const glm::dvec3 to = geometry.worldFromPixel(5.0, 5.0, 4);
    EXPECT_EQ(withHandleAt(angle, 1, to).points, (std::vector{angle.points[0], to, angle.points[2]}));
  });
}

}  // namespace
}  // namespace fenestra::sliceMeasureTest
