#pragma once
// A segmentation's or structure set's header, for the scan of a folder. Include in .cpp files alone.

#include "io/dicom/Dcmtk.h"
#include "io/dicom/DicomLabels.h"

namespace fenestra::io {

/// Label Map Segmentation Storage (PS3.4 B.5), which DCMTK 3.6.7 does not name.
inline constexpr const char* labelMapSegmentationClass = "1.2.840.10008.5.1.4.1.1.66.7";

/// Reads what is there; missing attributes stay empty.
DicomLabelObject labelObjectIn(DcmDataset& dataset, const std::filesystem::path& path);

}  // namespace fenestra::io
