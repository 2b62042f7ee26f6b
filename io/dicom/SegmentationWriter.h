#pragma once
// Label maps as DICOM segmentations that other programs show on their series.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/base/Reading.h"

namespace fenestra::io {

/// What a segmentation belongs to.
struct SegmentationOrigin {
  std::vector<std::filesystem::path> series;  ///< the DICOM files that the labels' volume was read from, or none
  bool namesPatient = true;  ///< false: identifiers link it to the series; what describes patient and study is empty
  std::string description = {};  ///< of its series, cut to 64 characters; empty: "Segmentation"
};

/// Writes the labels `wanted` (those without voxels are left out) as a binary segmentation (PS3.3 A.51), one frame for
/// each label and slice that holds it. Segments are numbered from 1, as the standard demands. Patient, study, frame of
/// reference and references to slices come from the origin's series; without it the segmentation has a new study of an
/// unnamed patient. Written beside and renamed. Throws Error, Cancelled.
void writeSegmentation(const LabelMap& labels, const std::vector<std::uint16_t>& wanted,
                       const SegmentationOrigin& origin, const std::filesystem::path& file,
                       const Progress& progress = {});

}  // namespace fenestra::io
