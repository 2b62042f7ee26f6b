#include "rendering/settings/Framing.h"

#include <algorithm>

namespace fenestra {

Framing::Framing(const Grid& grid) : centre(grid.centre()) {
  for (const glm::dvec3& corner : grid.corners()) points.push_back(corner);
}

double Framing::radius() const {
  double farthest = 0.0;
  for (const glm::dvec3& point : points) farthest = std::max(farthest, glm::distance(centre, point));
  return farthest;
}

}  // namespace fenestra
