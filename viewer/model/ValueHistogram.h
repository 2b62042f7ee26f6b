#pragma once
// How often each value occurs in a volume, for plots.

#include <cstdint>
#include <vector>

#include "rendering/scene/LabelMap.h"
#include "rendering/scene/Volume.h"

namespace fenestra::viewer {

/// Bins of equal width from `values.low` on. Of whole numbers a bin holds as many as any other, so that none is empty
/// by its place alone.
struct ValueHistogram {
  ValueRange values;  ///< real values from the first bin's lower to the last bin's upper end
  std::vector<std::uint32_t> counts;

  /// Mean count of the bins that a range of values meets; 0 outside.
  double density(ValueRange range) const;
};

/// From evenly spaced voxels, a quarter of a million of them: their curve is that of all voxels, and they take a few
/// milliseconds.
ValueHistogram histogramOf(const Volume& volume);
/// Of the voxels of one label, all of them, in the same bins; `labels` is on the volume's grid. Runs on all cores.
ValueHistogram histogramOf(const Volume& volume, const LabelMap& labels, std::uint16_t label);
/// Values below which `share` of the counted voxels lie, and above which as many do; the histogram's ends where none
/// is.
ValueRange middleOf(const ValueHistogram& histogram, double share);

}  // namespace fenestra::viewer
