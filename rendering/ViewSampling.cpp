#include "rendering/ViewSampling.h"

#include <algorithm>

#include "rendering/gpu/RayFrame.h"

namespace fenestra {
namespace {

/// Pixels that the narrowest side of a voxel in the volume's middle is wide.
double voxelWidthIn(const View& view, const Grid& grid) {
  const RayFrame rays(view.camera, view.size, grid);
  const double depth = rays.depthOf(grid.centre());
  return depth > 0.0 ? std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z}) / rays.pixelSize(depth) : 0.0;
}

/// Greatest distance of two neighbouring rays of a lattice, in pixels.
constexpr int widestPitch = 4;

/// Pixels from one ray that has to be followed to the next: a power of two, no more than a voxel is wide, so that what
/// the volume holds does not slip through; or else `least`.
int pitchOf(double voxelWidth, double least) {
  int pitch = widestPitch;
  while (pitch > std::max(voxelWidth, least)) pitch /= 2;
  return pitch;
}

}  // namespace

ViewSampling samplingOf(const View& view, const Grid& grid, bool lit) {
  if (view.maxError) return {.maxError = *view.maxError / 255.0};
  if (view.quality == Quality::High) return {.maxError = highQualityError / 255.0};
  const double voxelWidth = voxelWidthIn(view, grid);
  const bool draft = view.quality == Quality::Draft;
  ViewSampling sampling;
  if (draft) sampling.tolerance *= 3.0;
  // A lattice of squares meets the faces of the cells in much the same phase again and again, and takes bends of the
  // picture there for smooth. Such bends are sharpest where light shows those of the normals, and everywhere where
  // squares would be as wide as they may be.
  const double least = !lit ? widestPitch : draft ? 2.0 : 1.0;  // pixels a voxel is wide, for a quincunx
  sampling.quincunx = voxelWidth >= least && voxelWidth < 2 * widestPitch;
  sampling.pitch = sampling.quincunx ? 2 : pitchOf(voxelWidth, draft ? 2.0 : 1.0);
  return sampling;
}

}  // namespace fenestra
