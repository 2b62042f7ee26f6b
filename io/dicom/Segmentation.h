#pragma once
// DICOM segmentations (PS3.3 C.8.20): binary, fractional and label map. Include in .cpp files alone.

#include "io/base/LabelReading.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io {

/// Label Map Segmentation Storage (PS3.4 B.5), which DCMTK 3.6.7 does not name.
inline constexpr const char* labelMapSegmentationClass = "1.2.840.10008.5.1.4.1.1.66.7";

/// A segment's label, else its description or property type; may be empty.
std::string segmentName(DcmItem& segment, DcmDataset& dataset);

/// `dataset` is the file's header, without its pixels. Frames may come in any order; empty ones may be missing. Labels
/// are segment numbers. Throws Error, Cancelled.
LabelsOnGrid readSegmentation(DcmDataset& dataset, const std::filesystem::path& path, const Grid& target,
                              const Progress& progress);

}  // namespace fenestra::io
