#pragma once
// 3-D textures made plane by plane.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "rendering/gl/Texture.h"
#include "rendering/volume/Threads.h"

namespace fenestra {

/// Fills the texture slab by slab, so that there is no second copy of it and the processor's caches hold what is
/// copied: fill(z, plane) writes one plane of texels. Runs on all cores; while this thread gives a slab to OpenGL, the
/// others fill the next one.
template <class Texel, class Fill>
void uploadBySlabs(gl::Texture& texture, std::size_t texelsPerPlane, const Fill& fill) {
  constexpr std::size_t slabBytes = std::size_t{4} << 20;
  const glm::ivec3 size = texture.size();
  const int slab = static_cast<int>(
      std::clamp<std::size_t>(slabBytes / std::max<std::size_t>(texelsPerPlane * sizeof(Texel), 1), 1, 256));
  struct Slab {
    int z = 0, count = 0;
    std::vector<Texel> texels;
  } filled, next;
  for (int z = 0; z < size.z || filled.count > 0; z += slab) {
    next.z = z;
    next.count = std::clamp(size.z - z, 0, slab);
    next.texels.resize(texelsPerPlane * static_cast<std::size_t>(next.count));
    std::atomic<int> taken = 0;
    onEachCore([&](bool isCaller) {
      if (isCaller && filled.count > 0)
        texture.upload({0, 0, filled.z}, {size.x, size.y, filled.count}, std::as_bytes(std::span(filled.texels)));
      for (int i = taken++; i < next.count; i = taken++)
        fill(z + i, next.texels.data() + static_cast<std::size_t>(i) * texelsPerPlane);
    });
    std::swap(filled, next);
  }
}

inline std::size_t planeSize(glm::ivec3 dims) {
  return static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y);
}

}  // namespace fenestra
