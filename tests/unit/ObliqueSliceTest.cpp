// Planes of any direction through a volume: they cover it, at the places and steps that ObliqueSlice.h states.

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "rendering/volume/ObliqueSlice.h"

namespace fenestra::oblique_slice_test {
namespace {

constexpr SlicePlane planes[] = {SlicePlane::Axial, SlicePlane::Sagittal, SlicePlane::Coronal};

/// Anisotropic, turned and sheared, metres from the origin.
Grid awkward() {
  Grid grid;
  grid.dims = {23, 31, 17};
  grid.spacing = {0.7, 1.1, 2.9};
  grid.direction = glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.4, glm::normalize(glm::dvec3(1.0, -2.0, 0.5))));
  grid.direction[2] = glm::normalize(grid.direction[2] + 0.3 * grid.direction[1]);
  grid.origin = {1200.0, -800.0, 3000.0};
  return grid;
}

PlaneAxes turned(const PlaneAxes& axes, double angle, glm::dvec3 about) {
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), angle, glm::normalize(about)));
  return {turn * axes.right, turn * axes.down, turn * axes.normal};
}

glm::dvec3 world(const Grid& grid, glm::dvec3 index) {
  return glm::dvec3(grid.worldFromIndex() * glm::dvec4(index, 1.0));
}

TEST(ObliqueSlice, UnturnedPlanesAreTheVolumesOwn) {
  Grid grid;
  grid.dims = {20, 30, 10};
  grid.spacing = {0.8, 0.8, 2.5};
  grid.origin = {-7.0, 5.0, 11.0};
  for (const SlicePlane plane : planes) {
    const SliceGeometry own = sliceGeometry(grid, plane);
    // The pixels of the volume's own sagittal and coronal slices are not square.
    const double pixel = plane == SlicePlane::Axial ? 0.8 : 2.5;
    const SliceGeometry oblique =
        obliqueGeometry(grid, plane, planeAxes(grid, plane), own.worldFromPixel(4, 3, 2), pixel);
    EXPECT_EQ(oblique.count, own.count);
    EXPECT_EQ(oblique.height, own.height);
    EXPECT_NEAR(glm::length(oblique.normal - own.normal), 0.0, 1e-12);
    if (plane != SlicePlane::Axial) continue;
    EXPECT_EQ(oblique.width, own.width);
    EXPECT_NEAR(glm::length(oblique.origin - own.origin), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(oblique.right - own.right), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(oblique.down - own.down), 0.0, 1e-12);
  }
}

TEST(ObliqueSlice, AxesArePerpendicularAndKeepTheirHandedness) {
  for (const SlicePlane plane : planes) {
    const PlaneAxes axes = planeAxes(awkward(), plane);
    const glm::dmat3 frame(axes.right, axes.down, axes.normal);
    const glm::dmat3 product = glm::transpose(frame) * frame;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(product[i][j], i == j ? 1.0 : 0.0, 1e-12);
    EXPECT_NEAR(glm::determinant(frame), plane == SlicePlane::Sagittal ? -1.0 : 1.0, 1e-12);
  }
}

TEST(ObliqueSlice, CoversTheVolumeAndKeepsThePointOnAPixel) {
  const Grid grid = awkward();
  const glm::dvec3 through = world(grid, {7.3, 11.9, 4.2});
  for (const SlicePlane plane : planes)
    for (const double angle : {0.0, 0.3, 1.1, 2.9}) {
      const PlaneAxes axes = turned(planeAxes(grid, plane), angle, {0.2, 1.0, -0.7});
      const SliceGeometry geometry = obliqueGeometry(grid, plane, axes, through);
      const glm::dvec3 at = geometry.pixelFromWorld(through);
      // Origins of metres leave 1e-12 m.
      EXPECT_NEAR(glm::length(at - glm::round(at)), 0.0, 1e-9);
      for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 index = glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2) * glm::dvec3(grid.dims) - 0.5;
        const glm::dvec3 pixel = geometry.pixelFromWorld(world(grid, index));
        const glm::dvec3 counts(geometry.width, geometry.height, geometry.count);
        for (int k = 0; k < 3; ++k) {
          EXPECT_GE(pixel[k], -0.5 - 1e-5);
          EXPECT_LE(pixel[k], counts[k] - 0.5 + 1e-5);
        }
      }
      EXPECT_NEAR(glm::length(geometry.right), glm::length(geometry.down), 1e-12);
      const glm::dvec3 step = glm::dmat3(grid.indexFromWorld()) * geometry.normal;
      EXPECT_NEAR(std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)}), 1.0, 1e-9);
    }
}

TEST(ObliqueSlice, ShowsALinearFieldExactly) {
  Volume volume;
  volume.grid = awkward();
  volume.voxels = Voxels(ScalarType::Int16, volume.grid.voxelCount());
  auto scalars = volume.voxels.as<std::int16_t>();
  const glm::dvec3 slope(5.0, -3.0, 11.0);
  for (int z = 0, i = 0; z < volume.grid.dims.z; ++z)
    for (int y = 0; y < volume.grid.dims.y; ++y)
      for (int x = 0; x < volume.grid.dims.x; ++x, ++i)
        scalars[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(glm::dot(slope, glm::dvec3(x, y, z)));
  volume.computeRange();
  const PlaneAxes axes = turned(planeAxes(volume.grid, SlicePlane::Coronal), 0.8, {1.0, 0.4, 0.3});
  const SliceGeometry geometry =
      obliqueGeometry(volume.grid, SlicePlane::Coronal, axes, world(volume.grid, {11.0, 15.0, 8.0}));
  const int slice = static_cast<int>(std::lround(geometry.pixelFromWorld(world(volume.grid, {11.0, 15.0, 8.0})).z));
  const std::vector<float> values = sliceValues(volume, geometry, slice);
  int inside = 0;
  for (int j = 0; j < geometry.height; ++j)
    for (int i = 0; i < geometry.width; ++i) {
      const glm::dvec3 index(volume.grid.indexFromWorld() * glm::dvec4(geometry.worldFromPixel(i, j, slice), 1.0));
      // Half a voxel at the volume's rim repeats the outermost value.
      if (glm::any(glm::lessThan(index, glm::dvec3(0.0))) ||
          glm::any(glm::greaterThan(index, glm::dvec3(volume.grid.dims) - 1.0)))
        continue;
      ++inside;
      EXPECT_NEAR(values[static_cast<std::size_t>(j * geometry.width + i)], glm::dot(slope, index), 1e-3);
    }
  EXPECT_GT(inside, 300);
}

TEST(ObliqueSlice, NeedlesDoNotFillTheMemory) {
  Grid grid;
  grid.dims = {50, 50, 1000};
  grid.spacing = {0.001, 0.001, 10.0};
  const PlaneAxes axes = turned(planeAxes(grid, SlicePlane::Coronal), 0.5, {0.0, 1.0, 0.0});
  const SliceGeometry geometry = obliqueGeometry(grid, SlicePlane::Coronal, axes, {0.0, 0.0, 5000.0});
  EXPECT_LE(std::max(geometry.width, geometry.height), 4100);
}

}  // namespace
}  // namespace fenestra::oblique_slice_test
