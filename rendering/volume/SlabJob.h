#pragma once
// What the kernels of thick slices are given, and what they write.

#include <cstddef>

namespace fenestra {

/// Lengths along the lines are mm, positions and directions those of the grid's index.
struct SlabJob {
  const void* voxels = nullptr;
  int dims[3] = {};
  std::ptrdiff_t strides[3] = {};  ///< voxels to the next voxel of each axis; 0 where there is but one
  double first[3] = {};            ///< where the line of pixel (0, 0) crosses the slice
  double right[3] = {}, down[3] = {};
  double along[3] = {};  ///< a mm along the lines
  double half = 0.0;     ///< the lines reach this far to each side
  double piece = 0.0;    ///< positions are computed anew in double precision after each piece of this length
  double sign = 1.0;     ///< -1 looks for the minimum
  double slope = 1.0, intercept = 0.0;
  int width = 0, height = 0;
  float* values = nullptr;  ///< width·height
};

/// Pixels [left, right) × [top, bottom).
struct SlabTile {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// Fills the values of a tile. T is the type of the voxels.
using SlabKernel = void (*)(const SlabJob& job, const SlabTile& tile);

/// The kernel for voxels of type T on this processor: of means, or of extremes.
template <class T>
SlabKernel slabKernel(bool ofMeans);

}  // namespace fenestra
