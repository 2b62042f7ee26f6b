#include "rendering/viewpoints/Sphere.h"

#include <array>
#include <cmath>
#include <map>

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

long nestedPixel(int nside, glm::dvec3 direction) {
  long pixel = 0;
  vec2pix_nest(nside, &direction.x, &pixel);
  return pixel;
}

std::vector<std::optional<std::size_t>> oppositesOf(const std::vector<glm::dvec3>& directions) {
  // A direction on the edge of two roundings may miss its opposite; then each is looked at alone.
  using Key = std::array<long, 3>;
  const auto keyOf = [](glm::dvec3 direction) {
    const glm::dvec3 scaled = direction * 1e8;
    return Key{std::lround(scaled.x), std::lround(scaled.y), std::lround(scaled.z)};
  };
  std::map<Key, std::size_t> positions;
  for (std::size_t i = 0; i < directions.size(); ++i) positions[keyOf(directions[i])] = i;
  std::vector<std::optional<std::size_t>> opposites(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i)
    if (const auto at = positions.find(keyOf(-directions[i])); at != positions.end()) opposites[i] = at->second;
  // Of equal directions only one has the opposite for its own.
  for (std::size_t i = 0; i < directions.size(); ++i)
    if (opposites[i] && opposites[*opposites[i]] != i) opposites[i].reset();
  return opposites;
}

long ringPixel(int nside, glm::dvec3 direction) {
  long pixel = 0;
  vec2pix_ring(nside, &direction.x, &pixel);
  return pixel;
}

}  // namespace fenestra::placement
