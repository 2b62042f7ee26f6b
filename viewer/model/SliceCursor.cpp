#include "viewer/model/SliceCursor.h"

#include <algorithm>
#include <cmath>

namespace fenestra::viewer {

void SliceCursor::setGrid(const Grid& grid) {
  grid_ = grid;
  position_ = grid.centre();
  Q_EMIT moved();
}

void SliceCursor::moveTo(glm::dvec3 world) {
  const glm::dvec3 index = glm::clamp(glm::dvec3(grid_.indexFromWorld() * glm::dvec4(world, 1.0)), glm::dvec3(0.0),
                                      glm::dvec3(grid_.dims - 1));
  const glm::dvec3 inside(grid_.worldFromIndex() * glm::dvec4(index, 1.0));
  if (inside == position_) return;
  position_ = inside;
  Q_EMIT moved();
}

int SliceCursor::slice(const SliceGeometry& geometry) const {
  const double slice = geometry.pixelFromWorld(position_).z;
  return static_cast<int>(std::lround(std::clamp(slice, 0.0, std::max(0.0, geometry.count - 1.0))));
}

void SliceCursor::step(const SliceGeometry& geometry, int slices) {
  const glm::dvec3 pixel = geometry.pixelFromWorld(position_);
  const int target = std::clamp(slice(geometry) + slices, 0, std::max(0, geometry.count - 1));
  moveTo(geometry.worldFromPixel(pixel.x, pixel.y, target));
}

}  // namespace fenestra::viewer
