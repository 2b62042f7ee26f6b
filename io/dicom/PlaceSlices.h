#pragma once
// Where the slices of a stack are shown: as the headers place them when even planes can hold them, resampled onto
// regular planes otherwise or on request, and a report of both.
//
// Right geometry is the default: a volume whose slices lie up to centimetres from their true places looks normal and
// measures wrong. A tilted stack with even steps is exact as a sheared grid and stays as it was scanned, because
// resampling it would only blur it.

#include <optional>
#include <vector>

#include "io/base/Reading.h"
#include "io/dicom/DicomStack.h"
#include "io/dicom/SharedProgress.h"

namespace fenestra::io {

/// Gives `volume`, whose voxels are the stack's slices, its grid, and resamples the voxels where `wanted` asks for it
/// or Automatic finds it necessary. The report is empty where there is nothing to say. Throws Error when a requested
/// regular grid would be out of proportion or larger than memory, and Cancelled.
std::optional<GeometryReport> placeSlices(const DicomStack& stack, const std::vector<DicomFile>& files,
                                          Regularise wanted, const ProgressPart& progress, Volume& volume);

}  // namespace fenestra::io
