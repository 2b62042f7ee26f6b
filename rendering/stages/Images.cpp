#include "rendering/stages/Images.h"

namespace fenestra {

gl::Texture& sized(gl::Texture& image, gl::Format format, glm::ivec2 size, gl::Filter filter) {
  if (!image || glm::ivec2(image.size()) != size) image = gl::Texture::make2D(format, size, filter);
  return image;
}

void clearAround(const gl::Region& region, gl::Texture& picture) {
  const glm::ivec2 size(picture.size()), first = region.origin, end = first + region.size;
  picture.clear({0, 0}, {size.x, first.y});
  picture.clear({0, end.y}, {size.x, size.y - end.y});
  picture.clear({0, first.y}, {first.x, region.size.y});
  picture.clear({end.x, first.y}, {size.x - end.x, region.size.y});
}

gl::Region around(const gl::Region& a, const gl::Region& b) {
  const glm::ivec2 first = glm::min(a.origin, b.origin), end = glm::max(a.origin + a.size, b.origin + b.size);
  return {first, end - first};
}

gl::Region grown(const gl::Region& region, int margin, glm::ivec2 size) {
  const glm::ivec2 first = glm::max(region.origin - margin, 0),
                   end = glm::min(region.origin + region.size + margin, size);
  return {first, glm::max(end - first, 0)};
}

}  // namespace fenestra
