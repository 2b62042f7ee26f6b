#pragma once
// How often each value occurs in a volume, for plots.

#include <cstdint>
#include <vector>

#include "rendering/volume/LabelMap.h"
#include "rendering/volume/Volume.h"

namespace fenestra::viewer {

/// Bins of equal width from `values.low` on. Where values are whole numbers, every bin spans equally many of them, so
/// that no bin is empty only because of where it lies.
struct ValueHistogram {
  ValueRange values;  ///< real values from the first bin's lower to the last bin's upper end
  std::vector<std::uint32_t> counts;

  /// Mean count of the bins that a range of values meets; 0 outside.
  double density(ValueRange range) const;
};

/// Counts a quarter of a million evenly spaced voxels: their curve is that of all voxels, and they take a few
/// milliseconds.
ValueHistogram histogramOf(const Volume& volume);
/// Counts all voxels of one label, in the bins of the whole volume's histogram; `labels` is on the volume's grid. Runs
/// on all cores.
ValueHistogram histogramOf(const Volume& volume, const LabelMap& labels, std::uint16_t label);
/// Values below which `share` of the counted voxels lie, and above which as many do; the histogram's ends where none
/// is.
ValueRange middleOf(const ValueHistogram& histogram, double share);

}  // namespace fenestra::viewer
