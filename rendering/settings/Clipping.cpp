#include "rendering/settings/Clipping.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fenestra {

CropFrame::CropFrame(const Grid& grid)
    : axis(grid.patientAxes()),
      normal{},
      low(std::numeric_limits<double>::infinity()),
      high(-std::numeric_limits<double>::infinity()) {
  // Rows of the inverse are normal to the faces, in sheared grids, too.
  const glm::dmat3 faces = glm::transpose(glm::inverse(grid.direction));
  for (int patient = 0; patient < 3; ++patient) {
    const int index = axis[patient];
    const double side = grid.direction[index][patient] < 0.0 ? -1.0 : 1.0;
    normal[static_cast<std::size_t>(patient)] = side * glm::normalize(faces[index]);
  }
  for (const glm::dvec3& corner : grid.corners()) {
    low = glm::min(low, coordinates(corner));
    high = glm::max(high, coordinates(corner));
  }
}

glm::dvec3 CropFrame::coordinates(glm::dvec3 world) const {
  return {glm::dot(normal[0], world), glm::dot(normal[1], world), glm::dot(normal[2], world)};
}

glm::dvec3 CropFrame::world(glm::dvec3 coordinates) const {
  return glm::inverse(glm::transpose(glm::dmat3(normal[0], normal[1], normal[2]))) * coordinates;
}

std::vector<HalfSpace> halfSpaces(const Clipping& clipping, const Grid& grid) {
  std::vector<HalfSpace> result;
  if (clipping.cropped) {
    const CropFrame frame(grid);
    for (int a = 0; a < 3; ++a) {
      const glm::dvec3 normal = frame.normal[static_cast<std::size_t>(a)];
      // A face on the volume's own end clips nothing, rounding included.
      const double hair = 1e-6 * (frame.high[a] - frame.low[a]);
      if (clipping.box.low[a] > frame.low[a] + hair) result.push_back({normal, clipping.box.low[a]});
      if (clipping.box.high[a] < frame.high[a] - hair) result.push_back({-normal, -clipping.box.high[a]});
    }
  }
  const std::size_t planes = std::min(clipping.planes.size(), Clipping::mostPlanes);
  result.insert(result.end(), clipping.planes.begin(), clipping.planes.begin() + static_cast<std::ptrdiff_t>(planes));
  return result;
}

bool keeps(const std::vector<HalfSpace>& clip, glm::dvec3 world) {
  return std::all_of(clip.begin(), clip.end(), [&](const HalfSpace& each) { return each.distance(world) >= 0.0; });
}

}  // namespace fenestra
