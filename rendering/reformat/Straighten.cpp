#include "rendering/reformat/Straighten.h"

#include <cassert>
#include <cmath>
#include <limits>

#include "rendering/volume/ObliqueSlice.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reformat {
namespace {

/// Pixels across `width` mm, an odd number, so that one lies in the middle.
int pixelsAcross(double width, double spacing) { return 2 * static_cast<int>(std::floor(0.5 * width / spacing)) + 1; }

}  // namespace

StraightPicture straightened(const Volume& volume, const PathCurve& curve, double spacing, double width, double angle) {
  assert(curve.length() / spacing < largestStraightPicture && width / spacing < largestStraightPicture);
  StraightPicture picture;
  picture.spacing = spacing;
  picture.width = pixelsAcross(width, spacing);
  picture.height = static_cast<int>(std::floor(curve.length() / spacing + 1e-9)) + 1;
  const auto columns = static_cast<std::size_t>(picture.width);
  picture.values.assign(columns * static_cast<std::size_t>(picture.height), std::numeric_limits<float>::quiet_NaN());
  const glm::dmat4 toIndex = volume.grid.indexFromWorld();
  const glm::dvec3 low(-0.5), high = glm::dvec3(volume.grid.dims) - 0.5;
  parallelFor(static_cast<std::size_t>(picture.height), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      interruptionPoint();
      const PathPlace place = curve.place(static_cast<double>(row) * spacing);
      const glm::dvec3 across = std::cos(angle) * place.right + std::sin(angle) * place.up;
      for (std::size_t column = 0; column < columns; ++column) {
        const double mm = (static_cast<double>(column) - 0.5 * (picture.width - 1)) * spacing;
        const glm::dvec3 index(toIndex * glm::dvec4(place.point + mm * across, 1.0));
        if (glm::all(glm::greaterThanEqual(index, low)) && glm::all(glm::lessThanEqual(index, high)))
          picture.values[row * columns + column] = static_cast<float>(volume.sample(index));
      }
    }
  });
  return picture;
}

SliceGeometry crossSection(const PathCurve& curve, double mm, double spacing, double width, double angle) {
  const PathPlace place = curve.place(mm);
  PlaneAxes axes;
  axes.right = std::cos(angle) * place.right + std::sin(angle) * place.up;
  axes.down = std::cos(angle) * place.up - std::sin(angle) * place.right;
  axes.normal = place.along;
  return sliceAround(SlicePlane::Axial, axes, place.point, glm::ivec2(pixelsAcross(width, spacing)), spacing);
}

}  // namespace fenestra::reformat
