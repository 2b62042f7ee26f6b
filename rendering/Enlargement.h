#pragma once
// Enlarges pictures of few pixels on the CPU. Where the CPU draws, too, that takes a third of the time of a shader, for
// which the driver fetches each pixel's texels anew.

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra {

/// What lies behind a picture: a colour at the bottom, and what is added to it at the top.
struct PlainBackground {
  glm::vec3 bottom{0.0f}, rise{0.0f};
};

/// `picture`: premultiplied colours of `size` pixels, row by row from the top. Gives `shown` pixels in the same order,
/// each blue, green, red, alpha in 8 bits, opaque: the picture over the background, by the filter of
/// shaders/PresentEnlarged.frag. Runs on all cores.
std::vector<std::uint8_t> enlarged(std::span<const glm::vec4> picture, glm::ivec2 size, glm::ivec2 shown,
                                   const PlainBackground& background);

}  // namespace fenestra
