#include "rendering/scene/FocusDistances.h"

#include "rendering/scene/FocusVoxels.h"
#include "rendering/scene/Scene.h"

namespace fenestra {
namespace {

SampledLattice latticeOf(const Grid& grid, std::size_t most) {
  SampledLattice lattice;
  const glm::ivec3 lastCell = glm::max(grid.dims - 2, glm::ivec3(0));
  for (;;) {
    lattice.points = lastCell / lattice.step + 2;
    if (lattice.count() <= most) return lattice;
    int finest = -1;
    for (int axis = 0; axis < 3; ++axis)
      if (lattice.points[axis] > 2 &&
          (finest < 0 || grid.spacing[axis] * lattice.step[axis] < grid.spacing[finest] * lattice.step[finest]))
        finest = axis;
    if (finest < 0) return lattice;
    ++lattice.step[finest];
  }
}

/// mm from the middle of the volume.
std::vector<float> distancesFromMiddle(const Grid& grid, const SampledLattice& lattice) {
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  const glm::dvec3 middle = grid.centre();
  std::vector<float> distances;
  distances.reserve(lattice.count());
  for (int z = 0; z < lattice.points.z; ++z)
    for (int y = 0; y < lattice.points.y; ++y)
      for (int x = 0; x < lattice.points.x; ++x) {
        const glm::dvec3 index(lattice.step * glm::ivec3(x, y, z));
        distances.push_back(
            static_cast<float>(glm::distance(glm::dvec3(worldFromIndex * glm::dvec4(index, 1.0)), middle)));
      }
  return distances;
}

}  // namespace

float FocusDistances::at(glm::ivec3 point) const {
  const auto x = static_cast<std::size_t>(point.x), y = static_cast<std::size_t>(point.y),
             z = static_cast<std::size_t>(point.z);
  return millimetres[x +
                     static_cast<std::size_t>(lattice.points.x) * (y + static_cast<std::size_t>(lattice.points.y) * z)];
}

FocusDistances focusDistances(const Scene& scene, std::size_t most) {
  const Grid& grid = scene.volume->grid;
  FocusDistances distances;
  distances.lattice = latticeOf(grid, most);
  const FocusVoxels focus(scene);
  if (focus.flags().empty()) {
    distances.millimetres = distancesFromMiddle(grid, distances.lattice);
    return distances;
  }
  Grid box = grid;
  box.dims = focus.size();
  SampledLattice fromBox = distances.lattice;
  fromBox.first = -focus.low();
  distances.millimetres = distancesTo(focus.flags(), box, fromBox);
  return distances;
}

FocusDistances focusDistances(const Scene& scene) {
  return focusDistances(scene, std::size_t{1} << (isOrthogonal(scene.volume->grid) ? 24 : 21));
}

}  // namespace fenestra
