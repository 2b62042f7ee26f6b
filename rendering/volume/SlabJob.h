#pragma once
// What the kernels of thick slices are given, and what they write.

#include <cstdint>
#include <vector>

namespace fenestra {

/// A pixel's lines, all parallel. Positions and directions are those of the grid's index, lengths along the lines mm
/// from the slice.
struct SlabLines {
  double first[3] = {};  ///< where the line of pixel (0, 0) crosses the slice
  double right[3] = {}, down[3] = {};
  double along[3] = {};              ///< a mm
  double low[3] = {}, high[3] = {};  ///< the volume's box; lines end there
  double sign = 1.0;                 ///< -1 looks for the minimum
};

/// The voxels about some lines, copied so that they lie together, as int16 or double. Voxels outside the volume repeat
/// the outermost ones.
struct SlabBox {
  const void* voxels = nullptr;
  double first[3] = {};    ///< position of the first voxel
  int row = 0, plane = 0;  ///< voxels from row to row, and from plane to plane
};

/// Pixels [left, right) × [top, bottom), at most `side` each way.
struct SlabTile {
  static constexpr int side = 32;
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// What is known of the lines of a tile so far, stored values: by pixel, row by row from the tile's own corner.
struct SlabSums {
  double extreme[SlabTile::side * SlabTile::side];  ///< times SlabLines::sign; -infinity: none
  double sum[SlabTile::side * SlabTile::side];      ///< times mm
  double length[SlabTile::side * SlabTile::side];   ///< mm that count
};

/// Goes on along the lines of a tile, from `from` to `to`, which are at most 48 voxels apart.
using SlabKernel = void (*)(const SlabLines& lines, const SlabBox& box, const SlabTile& tile, double from, double to,
                            SlabSums& sums);

/// The kernels that this processor can run, the fastest first and the one for any processor last; of means or of
/// extremes, for boxes of int16, or of double.
std::vector<SlabKernel> slabKernels(bool ofMeans, bool ofInt16);

}  // namespace fenestra
