#pragma once
// DICOM segmentations (SEG, PS3.3 A.51) and structure sets (RTSTRUCT, PS3.3 A.19.3) as label maps.

#include <filesystem>

#include "io/base/LabelReading.h"

namespace fenestra::io {

/// The labels of a segmentation or structure set on `target`, by nearest label. Of a fractional segmentation, a voxel
/// belongs to a segment from one half on. Throws Error when the file is none or damaged; Cancelled.
LabelsOnGrid readDicomLabels(const std::filesystem::path& path, const Grid& target, const Progress& progress);

}  // namespace fenestra::io
