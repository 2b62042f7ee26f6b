#pragma once
// Thick slices: the maximum, minimum or mean of a volume along a slice's normal.
//
// Along a line, the trilinear field is a cubic within each cell of eight voxels. Its Bernstein coefficients are means
// of the field at the corners of the box that the line spans within the cell (its blossom), so that maximum and minimum
// follow from the cubic's stationary points and the mean from the coefficients' mean. Nothing is sampled: the only
// error is that of the arithmetic.

#include <cstdint>
#include <vector>

#include "rendering/volume/Slice.h"

namespace fenestra {

enum class SlabMode : std::uint8_t { Maximum, Minimum, Mean };

struct Slab {
  double thickness = 0.0;  ///< mm, half of it to each side of the slice; 0 is the slice alone
  SlabMode mode = SlabMode::Maximum;
  bool operator==(const Slab&) const = default;
};

/// Real values of a thick slice, row by row from the top, width·height of them: of the field that Volume::sample()
/// gives, which repeats the outermost voxels for half a voxel beyond their centres, along the line through the pixel's
/// centre that is perpendicular to the picture (also where the grid is sheared). Parts of the line outside the volume
/// do not count, nor do cells that hold a value that is no number; NaN where nothing is left. Thickness 0 gives
/// sliceValues(). Volumes of up to 16 bits are computed in float32 and differ from the exact value by less than a
/// hundredth of a stored step, others in float64. The thickness must be a finite number ≥ 0. Runs on all cores.
std::vector<float> slabValues(const Volume& volume, const SliceGeometry& geometry, int slice, const Slab& slab);

}  // namespace fenestra
