#pragma once
// The slices of one volume. World is LPS mm.

#include <vector>

#include "io/base/Reading.h"
#include "io/dicom/DicomFile.h"

namespace fenestra::io {

/// Slices that form one volume, in the order of their positions along the slices' normal.
struct DicomStack {
  std::vector<DicomFrame> frames;
  /// Sheared where the gantry was tilted. The step between slices is (last - first) / (n - 1): with uneven slices both
  /// ends are exact, and those between are displaced; SliceLayout.h says how far, Regular.h puts that right.
  Grid grid;
  /// Time points of one place share a group, and are numbered from 1; 0: it is no time point.
  int group = 0, time = 0, times = 0;
  std::string part;               ///< "echo time 4.92 ms": what tells it from other volumes of its series; may be empty
  std::vector<Warning> warnings;  ///< which slices belong to it; not where they lie
};

}  // namespace fenestra::io
