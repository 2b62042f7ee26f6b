#include "rendering/placement/Sphere.h"

#include <chealpix.h>

namespace fenestra::placement {

std::optional<int> sideOf(int count) {
  const long side = count >= 12 ? npix2nside(count) : -1;
  return side > 0 ? std::optional(static_cast<int>(side)) : std::nullopt;
}

std::vector<glm::dvec3> ringDirections(int nside) {
  std::vector<glm::dvec3> directions(static_cast<std::size_t>(nside2npix(nside)));
  for (std::size_t pixel = 0; pixel < directions.size(); ++pixel)
    pix2vec_ring(nside, static_cast<long>(pixel), &directions[pixel].x);
  return directions;
}

glm::dvec3 nestedDirection(int nside, long pixel) {
  glm::dvec3 direction;
  pix2vec_nest(nside, pixel, &direction.x);
  return direction;
}

long ringPixel(int nside, glm::dvec3 direction) {
  long pixel = 0;
  vec2pix_ring(nside, &direction.x, &pixel);
  return pixel;
}

}  // namespace fenestra::placement
