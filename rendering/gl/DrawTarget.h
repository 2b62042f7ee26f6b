#pragma once
// Where the rasteriser draws, and the state that is restored afterwards.

#include <array>
#include <cstdint>

#include <glm/glm.hpp>

namespace fenestra::gl {

class Texture;

/// Draws into `framebuffer` over a rectangle (x, y from the bottom left, width, height) while it lives; afterwards
/// framebuffer, viewport, blending, depth, scissor and program are what they were.
class DrawTarget {
 public:
  DrawTarget(std::uint32_t framebuffer, glm::ivec4 rectangle);
  /// Draws over the whole of a 2-D texture, whose first row is the lowest.
  explicit DrawTarget(const Texture& texture);
  ~DrawTarget();
  DrawTarget(const DrawTarget&) = delete;
  DrawTarget& operator=(const DrawTarget&) = delete;

 private:
  std::uint32_t own_ = 0;  ///< framebuffer of a texture
  int framebuffer_ = 0, program_ = 0;
  std::array<int, 4> viewport_{};
  bool blend_ = false, depth_ = false, scissor_ = false, cull_ = false;
};

}  // namespace fenestra::gl
