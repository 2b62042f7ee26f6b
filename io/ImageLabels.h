#pragma once
// Label maps in the formats of volumes.

#include "io/Probe.h"
#include "io/base/LabelReading.h"

namespace fenestra::io {

/// The labels of a file of any format but Dicom and Archive on `target`, by nearest label, with the names and colours
/// that the file itself gives (3D Slicer's segments in NRRD, label tables in NIfTI). `allowOutside` as in OpenOptions.
/// Throws Error, Cancelled.
LabelsOnGrid readImageLabels(const std::filesystem::path& path, Format format, const Grid& target,
                             const Progress& progress, bool allowOutside);

}  // namespace fenestra::io
