#pragma once
// Which of several series is opened when none is named.
//
// A series comes first by the first of these in which two differ:
//   1. its geometry is plausible;
//   2. it was acquired: no localiser, no secondary capture, no picture made from other series (reformats, projections);
//   3. it is a volume of at least `leastSlices` slices; then a stack of several; a single image comes last;
//   4. Image Type says ORIGINAL\PRIMARY;
//   5. the step between its slices is smaller; of volumes alone, since a few thin slices are no volume;
//   6. it has more voxels;
//   7. its series number is lower; those without one come last;
//   8. its id, in natural order, so that the order of files does not matter.
// Values of Image Type: DICOM PS3.3 C.7.6.1.1.2, C.8.2.1.1.1 (CT), C.8.3.1.1.1 (MR).

#include <string>
#include <vector>

#include "io/base/Reading.h"

namespace fenestra::io {

inline constexpr int leastSlices = 16;  ///< of a volume: fewer cover no organ at any usual step

struct SeriesChoice {
  std::size_t index = 0;  ///< of the series that comes first
  Phrase reason;          ///< VolumeInfo::reason
};

/// `series` must not be empty.
SeriesChoice firstSeries(const std::vector<SeriesInfo>& series);

}  // namespace fenestra::io
