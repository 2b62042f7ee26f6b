#include "rendering/gpu/Occluders.h"

namespace fenestra {

bool Occluders::update(const Scene& scene, const FocusIndex& focus, const Key& key) {
  const bool wanted = hasOcclusion(scene.look);
  if (!wanted && !any()) return false;
  if (wanted && isOf(key)) return false;
  release();
  if (!wanted) return true;
  // The index has the same cells, in a frame that begins half a voxel before the first.
  cells_ = occluderCells(scene, [&focus](glm::ivec3 cell) { return focus.holds(cell + 1); });
  buffer_ = gl::Buffer(std::as_bytes(std::span(cells_.extinction)));
  key_ = key;
  return true;
}

void Occluders::bind() const {
  constexpr unsigned cellsBinding = 4;  // of Occluders.comp
  buffer_.bind(cellsBinding);
}

}  // namespace fenestra
