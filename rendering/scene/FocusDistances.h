#pragma once
// How far from the focus a place lies, for a focal region that follows its shape (MethodStages::Fading::Region in
// Method.h).

#include <vector>

#include "rendering/volume/DistanceTransform.h"

namespace fenestra {

struct Scene;

/// D(p), in mm: trilinear between the points of a lattice, on which it is the distance to the nearest centre of a voxel
/// in focus, or to the volume's middle where there is none. Outside of the box of the outermost voxels' centres it is
/// that of the box's nearest place in index coordinates. The lattice has every voxel; of a large volume every second,
/// third and so on along its finest axes, so that each cell of voxels lies in one of the lattice.
struct FocusDistances {
  SampledLattice lattice;  ///< counted in voxels, from the first one; the last points may lie beyond the voxels
  std::vector<float> millimetres;

  float at(glm::ivec3 point) const;
};

/// Distances on a lattice of at most `most` points. `scene` has a volume.
FocusDistances focusDistances(const Scene& scene, std::size_t most);
/// Distances on the lattice that pictures use: at most 2^24 points, or 2^21 on a sheared grid.
FocusDistances focusDistances(const Scene& scene);

}  // namespace fenestra
