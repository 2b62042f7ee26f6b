#pragma once
// Images as large as a picture.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"

namespace fenestra {

/// The image itself, made anew where its size is another.
gl::Texture& sized(gl::Texture& image, gl::Format format, glm::ivec2 size, gl::Filter filter = gl::Filter::Nearest);

/// For images that may be presented: a draft is smaller than the rectangle that it fills.
inline constexpr gl::Filter presented = gl::Filter::Linear;

/// Fills all of a picture but one region with zeros.
void clearAround(const gl::Region& region, gl::Texture& picture);

/// Smallest region that holds both.
gl::Region around(const gl::Region& a, const gl::Region& b);

/// The region with so many pixels more on each side, within a picture.
gl::Region grown(const gl::Region& region, int margin, glm::ivec2 size);

}  // namespace fenestra
