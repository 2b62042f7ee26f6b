#include "io/base/PlausibleGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/base/Error.h"

namespace fenestra::io {
namespace {

constexpr double leastVoxel = 1e-6, greatestVoxel = 1e3;  // mm: 1 nm and 1 m
constexpr double greatestSide = 1e5, farthest = 1e6;      // mm: 100 m and 1 km

std::string shortly(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace

std::optional<std::string> implausibility(const Grid& grid) {
  for (int axis = 0; axis < 3; ++axis) {
    const double spacing = grid.spacing[axis];
    if (!(spacing >= leastVoxel && spacing <= greatestVoxel))
      return "its voxels measure " + shortly(spacing) + " mm, which no scanner's do (1 nm to 1 m)";
    if (spacing * grid.dims[axis] > greatestSide)
      return "it measures " + shortly(spacing * grid.dims[axis] / 1000.0) + " m along one side, more than 100 m";
  }
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(glm::length(grid.direction[axis]) - 1.0) < 1e-3)) return "its axes have no direction";
  if (!areIndependent(grid.direction)) return "its axes lie in a plane";
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(grid.origin[axis]) < farthest))
      return "its position is " + shortly(grid.origin[axis]) + " mm, further than 1 km from the origin";
  return std::nullopt;
}

bool areIndependent(const glm::dmat3& axes) { return std::abs(glm::determinant(axes)) > 1e-4; }

void checkGeometry(const std::filesystem::path& path, const Grid& grid) {
  if (const auto wrong = implausibility(grid))
    throw Error(path, "its geometry is not plausible: " + *wrong, "the header is damaged; get the file again");
}

}  // namespace fenestra::io
