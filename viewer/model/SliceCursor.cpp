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
  const glm::dvec3 world = geometry.worldFromPixel(pixel.x, pixel.y, target);
  moveTo(geometry.axis < 0 ? nearestOnPlane(world, geometry) : world);
}

glm::dvec3 SliceCursor::nearestOnPlane(glm::dvec3 point, const SliceGeometry& geometry) const {
  const glm::dvec3 normal = glm::normalize(geometry.normal);
  const glm::dmat4 indexFromWorld = grid_.indexFromWorld(), worldFromIndex = grid_.worldFromIndex();
  // Projects onto the box and onto the plane in turn, which leads to a point of both (von Neumann's alternating
  // projections); where the plane misses the box of voxel centres, to the nearest points of the two.
  glm::dvec3 at = point;
  constexpr int most = 200;
  for (int i = 0; i < most; ++i) {
    const glm::dvec3 index =
        glm::clamp(glm::dvec3(indexFromWorld * glm::dvec4(at, 1.0)), glm::dvec3(0.0), glm::dvec3(grid_.dims - 1));
    const glm::dvec3 inside(worldFromIndex * glm::dvec4(index, 1.0));
    const double off = glm::dot(point - inside, normal);
    at = inside + off * normal;
    if (std::abs(off) < 1e-6 * glm::length(geometry.normal)) break;
  }
  return at;
}

}  // namespace fenestra::viewer
