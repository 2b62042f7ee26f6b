#include "rendering/viewpoints/Sphere.h"

#include <array>
#include <cmath>
#include <map>

#include <healpix_base.h>

namespace fenestra::placement {
namespace {

Healpix_Base ring(int nside) { return {nside, RING, SET_NSIDE}; }
Healpix_Base nested(int nside) { return {nside, NEST, SET_NSIDE}; }

glm::dvec3 directionOf(const Healpix_Base& sphere, int pixel) {
  const vec3 direction = sphere.pix2vec(pixel);
  return {direction.x, direction.y, direction.z};
}

int pixelAt(const Healpix_Base& sphere, glm::dvec3 direction) {
  return sphere.vec2pix({direction.x, direction.y, direction.z});
}

}  // namespace

std::optional<int> sideOf(int count) {
  if (count < 12) return std::nullopt;
  const int nside = static_cast<int>(std::lround(std::sqrt(count / 12.0)));
  return count % 12 == 0 && count / 12 == nside * nside ? std::optional(nside) : std::nullopt;
}

std::span<const glm::dvec3, 6> standardDirections() {
  static const std::array<glm::dvec3, 6> directions{glm::dvec3(0, -1, 0), glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0),
                                                    glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)};
  return directions;
}

std::vector<glm::dvec3> ringDirections(int nside) {
  const Healpix_Base sphere = ring(nside);
  std::vector<glm::dvec3> directions;
  for (int pixel = 0; pixel < sphere.Npix(); ++pixel) directions.push_back(directionOf(sphere, pixel));
  return directions;
}

int ringPixel(int nside, glm::dvec3 direction) { return pixelAt(ring(nside), direction); }

glm::dvec3 nestedDirection(int nside, int pixel) { return directionOf(nested(nside), pixel); }

int nestedPixel(int nside, glm::dvec3 direction) { return pixelAt(nested(nside), direction); }

std::vector<int> nestedNeighbours(int nside, int pixel) {
  fix_arr<int, 8> found;
  nested(nside).neighbors(pixel, found);
  std::vector<int> neighbours;
  for (int i = 0; i < 8; ++i)
    if (found[static_cast<std::size_t>(i)] >= 0) neighbours.push_back(found[static_cast<std::size_t>(i)]);
  return neighbours;
}

std::vector<std::optional<std::size_t>> oppositesOf(const std::vector<glm::dvec3>& directions) {
  // Two opposite directions may round to different keys; then each is measured alone.
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
  // Where directions repeat, only one of the equal ones keeps the opposite.
  for (std::size_t i = 0; i < directions.size(); ++i)
    if (opposites[i] && opposites[*opposites[i]] != i) opposites[i].reset();
  return opposites;
}

}  // namespace fenestra::placement
