#include "rendering/volume/Slab.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <limits>

#include "rendering/volume/SlabJob.h"
#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

void put(double (&to)[3], glm::dvec3 from) {
  for (int axis = 0; axis < 3; ++axis) to[axis] = from[axis];
}

SlabJob slabJob(const Volume& volume, const SliceGeometry& geometry, int slice, const Slab& slab) {
  const Grid& grid = volume.grid;
  const glm::dmat3 linear(grid.indexFromWorld());
  SlabJob job;
  job.voxels = volume.voxels.data();
  std::ptrdiff_t stride = 1;
  for (int axis = 0; axis < 3; ++axis) {
    job.dims[axis] = grid.dims[axis];
    job.strides[axis] = grid.dims[axis] > 1 ? stride : 0;
    stride *= grid.dims[axis];
  }
  // Subtracting the origins first keeps the precision where both are metres away.
  put(job.first, linear * (geometry.worldFromPixel(0, 0, slice) - grid.origin));
  put(job.right, linear * geometry.right);
  put(job.down, linear * geometry.down);
  // In a sheared grid, the step from slice to slice is not perpendicular to them.
  glm::dvec3 along = linear * glm::normalize(glm::cross(geometry.right, geometry.down));
  const double greatest = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
  // What rounding left of an axis that the lines do not follow would move them by no thousandth of a voxel.
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(along[axis]) < 1e-9 * greatest) along[axis] = 0.0;
  put(job.along, along);
  job.half = 0.5 * slab.thickness;
  // Over so many voxels, float32 keeps positions to a millionth of a voxel, and offsets fit in 32 bits.
  job.piece = 32.0 / greatest;
  job.sign = (slab.mode == SlabMode::Maximum) == (volume.slope >= 0.0) ? 1.0 : -1.0;
  job.slope = volume.slope;
  job.intercept = volume.intercept;
  job.width = geometry.width;
  job.height = geometry.height;
  return job;
}

}  // namespace

std::vector<float> slabValues(const Volume& volume, const SliceGeometry& geometry, int slice, const Slab& slab) {
  assert(std::isfinite(slab.thickness) && slab.thickness >= 0.0);
  if (slab.thickness == 0.0) return sliceValues(volume, geometry, slice);
  std::vector<float> values(static_cast<std::size_t>(geometry.width) * static_cast<std::size_t>(geometry.height));
  SlabJob job = slabJob(volume, geometry, slice, slab);
  job.values = values.data();
  const SlabKernel kernel = volume.voxels.visit(
      [&](auto scalars) { return slabKernel<typename decltype(scalars)::value_type>(slab.mode == SlabMode::Mean); });
  // The voxels about the lines of a tile fit in a core's own memory. Cores take tiles in turns, because those outside
  // the volume take no time.
  constexpr int side = 32;
  const int across = (job.width + side - 1) / side, tiles = across * ((job.height + side - 1) / side);
  std::atomic<int> next = 0;
  onEachCore([&](bool) {
    for (int tile = next++; tile < tiles; tile = next++) {
      interruptionPoint();
      const int left = tile % across * side, top = tile / across * side;
      kernel(job, {left, top, std::min(left + side, job.width), std::min(top + side, job.height)});
    }
  });
  return values;
}

}  // namespace fenestra
