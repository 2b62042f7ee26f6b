#pragma once
// The headers of segmentations and structure sets, for the scan of a folder: which of them belong to a series.

#include <filesystem>
#include <set>
#include <string>

#include "io/base/Reading.h"

class DcmDataset;

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

/// Reads what is there; missing attributes stay empty.
DicomLabelObject labelObjectIn(DcmDataset& dataset, const std::filesystem::path& path);

}  // namespace fenestra::io
