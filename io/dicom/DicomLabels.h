#pragma once
// DICOM segmentations (SEG, PS3.3 A.51) and structure sets (RTSTRUCT, PS3.3 A.19.3) as label maps, and which of them
// belong to a series.

#include <filesystem>
#include <set>
#include <string>

#include "io/base/LabelReading.h"

namespace fenestra::io {

/// A segmentation or structure set as far as listing it needs.
struct DicomLabelObject {
  SegmentationInfo info;
  std::set<std::string> series;  ///< SeriesInstanceUIDs of the images that it was made from; may be empty
  std::string frameOfReference;  ///< UID; may be empty
  /// Whether it was made from the series; one that names no series belongs to all of its frame of reference.
  bool belongsTo(const std::string& seriesUid, const std::string& frame) const;
};

/// Whether objects of the class (SOP Class UID) hold labels: segmentations, label maps, structure sets.
bool isLabelClass(const std::string& sopClass);

/// The labels of a segmentation or structure set on `target`, by nearest label. Of a fractional segmentation, a voxel
/// belongs to a segment from one half on. Throws Error when the file is none or damaged; Cancelled.
LabelsOnGrid readDicomLabels(const std::filesystem::path& path, const Grid& target, const Progress& progress);

}  // namespace fenestra::io
