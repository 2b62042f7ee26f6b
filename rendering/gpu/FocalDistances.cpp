#include "rendering/gpu/FocalDistances.h"

#include <span>

#include "rendering/scene/Fading.h"

namespace fenestra {

void FocalDistances::update(const Scene& scene, Key key) {
  const bool wanted = fadesByDistance(scene.look);
  if (!wanted) return release();
  if (any() && key == key_) return;
  release();
  const FocusDistances distances = focusDistances(scene);
  lattice_ = distances.lattice;
  buffer_ = gl::Buffer(std::as_bytes(std::span(distances.millimetres)));
  key_ = key;
}

}  // namespace fenestra
