#pragma once
// 3-D textures made plane by plane.

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "rendering/gl/Texture.h"
#include "rendering/volume/Threads.h"

namespace fenestra {

/// Fills the texture slab by slab, so that there is no second copy of it: fill(z, plane) writes one plane of texels.
/// Runs on all cores.
template <class Texel, class Fill>
void uploadBySlabs(gl::Texture& texture, std::size_t texelsPerPlane, const Fill& fill) {
  constexpr std::size_t slabBytes = std::size_t{16} << 20;
  const int depth = texture.size().z;
  const int slab = static_cast<int>(
      std::clamp<std::size_t>(slabBytes / std::max<std::size_t>(texelsPerPlane * sizeof(Texel), 1), 1, 256));
  std::vector<Texel> texels;
  for (int z = 0; z < depth; z += slab) {
    const int count = std::min(slab, depth - z);
    texels.resize(texelsPerPlane * static_cast<std::size_t>(count));
    parallelFor(static_cast<std::size_t>(count), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) fill(z + static_cast<int>(i), texels.data() + i * texelsPerPlane);
    });
    texture.upload({0, 0, z}, {texture.size().x, texture.size().y, count}, std::as_bytes(std::span(texels)));
  }
}

inline std::size_t planeSize(glm::ivec3 dims) {
  return static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y);
}

}  // namespace fenestra
