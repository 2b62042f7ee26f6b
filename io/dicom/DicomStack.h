#pragma once
// From single slices to volumes: which belong together, in which order, on which grid, and what is odd about them.
// Geometry alone; knows no files and no pixels. World is LPS mm.

#include <vector>

#include "io/base/Reading.h"
#include "io/dicom/DicomHeader.h"

namespace fenestra::io {

/// Slices that form one volume, in the order of their positions along the slices' normal.
struct DicomStack {
  std::vector<DicomFrame> frames;
  /// Sheared where the gantry was tilted. The step between slices is (last - first) / (n - 1): with uneven slices both
  /// ends are exact, and those between are displaced; SliceLayout.h says how far, Regular.h puts that right.
  Grid grid;
  /// Time points of one place share a group, and are numbered from 1; 0: it is no time point.
  int group = 0, time = 0, times = 0;
  std::vector<Warning> warnings;  ///< which slices belong to it; not where they lie
};

/// The volumes among the frames of one series, largest first. `files` are the scanned files that frames refer to.
/// Slices are told apart by size, orientation, spacing, frame of reference, frame type and stack; frames of reference
/// of single slices are none and do not count. A slice further away than ten times the usual distance, and the second
/// and later frames at one position, form volumes of their own.
std::vector<DicomStack> stackFrames(const std::vector<DicomFrame>& frames, const std::vector<DicomFile>& files);

}  // namespace fenestra::io
