#include "rendering/volume/ObliqueSlice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fenestra {
namespace {

/// Most pixels along a side, where the caller names no size of a pixel: a volume of 1 mm slices of 1 µm pixels would
/// fill the memory otherwise.
constexpr double largestSide = 4096.0;

}  // namespace

bool isPerpendicular(const PlaneAxes& axes) {
  const glm::dmat3 matrix(axes.right, axes.down, axes.normal);
  const glm::dmat3 rest = glm::transpose(matrix) * matrix - glm::dmat3(1.0);
  constexpr double rounding = 1e-5;
  // Written so that what is no number is none either.
  for (int column = 0; column < 3; ++column)
    if (!glm::all(glm::lessThan(glm::abs(rest[column]), glm::dvec3(rounding)))) return false;
  return true;
}

PlaneAxes planeAxes(const Grid& grid, SlicePlane plane) {
  const SliceGeometry geometry = sliceGeometry(grid, plane);
  PlaneAxes axes;
  axes.right = glm::normalize(geometry.right);
  axes.down = glm::normalize(geometry.down - glm::dot(geometry.down, axes.right) * axes.right);
  const glm::dvec3 normal = glm::cross(axes.right, axes.down);
  axes.normal = glm::dot(normal, geometry.normal) < 0.0 ? -normal : normal;
  return axes;
}

double voxelLength(const Grid& grid, glm::dvec3 direction) {
  const glm::dvec3 voxelsPerMm = glm::abs(glm::dmat3(grid.indexFromWorld()) * direction);
  return 1.0 / std::max({voxelsPerMm.x, voxelsPerMm.y, voxelsPerMm.z});
}

SliceGeometry obliqueGeometry(const Grid& grid, SlicePlane plane, const PlaneAxes& axes, glm::dvec3 through,
                              std::optional<double> pixel) {
  const glm::dmat3 fromPatient = glm::transpose(glm::dmat3(axes.right, axes.down, axes.normal));
  // The volume's box along the axes, in mm from `through`.
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 index = glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2) * glm::dvec3(grid.dims) - 0.5;
    const glm::dvec3 place = fromPatient * (glm::dvec3(grid.worldFromIndex() * glm::dvec4(index, 1.0)) - through);
    low = glm::min(low, place);
    high = glm::max(high, place);
  }

  const double finest = std::min(voxelLength(grid, axes.right), voxelLength(grid, axes.down));
  const double coarsest = std::max(high.x - low.x, high.y - low.y) / largestSide;
  const double side = pixel.value_or(std::max(finest, coarsest));
  const glm::dvec3 step(side, side, voxelLength(grid, axes.normal));
  // A pixel reaches half a step beyond its centre. Rounding adds no pixel to a box that ends there.
  constexpr double rounding = 1e-6;
  const glm::dvec3 first = glm::min(glm::ceil(low / step - 0.5 + rounding), glm::dvec3(0.0));
  const glm::dvec3 last = glm::max(glm::floor(high / step + 0.5 - rounding), glm::dvec3(0.0));
  const glm::ivec3 counts(last - first + 1.0);

  SliceGeometry geometry;
  geometry.plane = plane;
  geometry.axis = -1;
  geometry.width = counts.x;
  geometry.height = counts.y;
  geometry.count = counts.z;
  geometry.right = axes.right * step.x;
  geometry.down = axes.down * step.y;
  geometry.normal = axes.normal * step.z;
  geometry.origin = through + first.x * geometry.right + first.y * geometry.down + first.z * geometry.normal;
  return geometry;
}

SlicePlane nearestPlane(const Grid& grid, glm::dvec3 normal) {
  SlicePlane nearest = SlicePlane::Axial;
  double most = -1.0;
  for (const SlicePlane plane : {SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal}) {
    const double along = std::abs(glm::dot(normal, planeAxes(grid, plane).normal));
    // Between two of them, rounding does not decide.
    if (along > most * (1.0 + 1e-9)) {
      nearest = plane;
      most = along;
    }
  }
  return nearest;
}

PlaneAxes planeAxes(const Grid& grid, glm::dvec3 normal) {
  const PlaneAxes near = planeAxes(grid, nearestPlane(grid, normal));
  PlaneAxes axes;
  axes.normal = glm::normalize(glm::dot(normal, near.normal) < 0.0 ? -normal : normal);
  axes.down = glm::normalize(near.down - glm::dot(near.down, axes.normal) * axes.normal);
  axes.right = glm::normalize(glm::cross(axes.down, axes.normal));
  if (glm::dot(axes.right, near.right) < 0.0) axes.right = -axes.right;
  return axes;
}

SliceGeometry sliceAround(SlicePlane plane, const PlaneAxes& axes, glm::dvec3 centre, glm::ivec2 size, double pixel) {
  SliceGeometry geometry;
  geometry.plane = plane;
  geometry.axis = -1;
  geometry.count = 1;
  geometry.width = size.x;
  geometry.height = size.y;
  geometry.right = axes.right * pixel;
  geometry.down = axes.down * pixel;
  geometry.normal = axes.normal * pixel;
  geometry.origin = centre - 0.5 * (size.x - 1) * geometry.right - 0.5 * (size.y - 1) * geometry.down;
  return geometry;
}

}  // namespace fenestra
