#include "rendering/volume/Grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fenestra {

std::size_t Grid::voxelCount() const {
  return static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z);
}

glm::dmat4 Grid::worldFromIndex() const {
  return {glm::dvec4(direction[0] * spacing.x, 0.0), glm::dvec4(direction[1] * spacing.y, 0.0),
          glm::dvec4(direction[2] * spacing.z, 0.0), glm::dvec4(origin, 1.0)};
}

glm::dmat4 Grid::indexFromWorld() const {
  // Inverting the 3×3 part alone keeps the precision that a general 4×4 inverse loses when the origin is metres away.
  const glm::dmat3 linear =
      glm::inverse(glm::dmat3(direction[0] * spacing.x, direction[1] * spacing.y, direction[2] * spacing.z));
  return {glm::dvec4(linear[0], 0.0), glm::dvec4(linear[1], 0.0), glm::dvec4(linear[2], 0.0),
          glm::dvec4(-(linear * origin), 1.0)};
}

double Grid::voxelVolume() const { return std::abs(glm::determinant(direction)) * spacing.x * spacing.y * spacing.z; }

glm::dvec3 Grid::centre() const {
  return glm::dvec3(worldFromIndex() * glm::dvec4((glm::dvec3(dims) - 1.0) * 0.5, 1.0));
}

std::array<glm::dvec3, 8> Grid::corners() const {
  const glm::dmat4 worldFrom = worldFromIndex();
  std::array<glm::dvec3, 8> result;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 index((corner & 1) ? dims.x - 0.5 : -0.5, (corner & 2) ? dims.y - 0.5 : -0.5,
                           (corner & 4) ? dims.z - 0.5 : -0.5);
    result[static_cast<std::size_t>(corner)] = glm::dvec3(worldFrom * glm::dvec4(index, 1.0));
  }
  return result;
}

double Grid::boundingRadius() const {
  const glm::dvec3 middle = centre();
  double radius = 0.0;
  for (const glm::dvec3& corner : corners()) radius = std::max(radius, glm::distance(middle, corner));
  return radius;
}

bool Grid::contains(glm::ivec3 index) const {
  return glm::all(glm::greaterThanEqual(index, glm::ivec3(0))) && glm::all(glm::lessThan(index, dims));
}

glm::ivec3 Grid::patientAxes() const {
  std::array<int, 3> order{0, 1, 2}, best = order;
  double greatest = -1.0;
  do {
    const double product = std::abs(direction[order[0]].x * direction[order[1]].y * direction[order[2]].z);
    if (product > greatest) {
      greatest = product;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return {best[0], best[1], best[2]};
}

std::size_t Grid::offset(glm::ivec3 index) const {
  return static_cast<std::size_t>(index.x) +
         static_cast<std::size_t>(dims.x) *
             (static_cast<std::size_t>(index.y) + static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(index.z));
}

}  // namespace fenestra
