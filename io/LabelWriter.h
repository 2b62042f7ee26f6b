#pragma once
// Label maps to disk as other programs read them.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/base/Reading.h"

namespace fenestra::io {

struct LabelOutput {
  std::vector<std::uint16_t> only = {};            ///< labels to write, ascending; empty: all
  std::vector<std::filesystem::path> series = {};  ///< the files of the labels' volume; a DICOM segmentation
                                                   ///< refers to them where they are DICOM
  bool namesPatient = true;                        ///< a DICOM segmentation has the patient of `series`
  std::string description = {};                    ///< of a DICOM segmentation's series; empty: "Segmentation"
};

/// The file endings that writeLabels knows, for dialogs and messages.
inline constexpr const char* labelEndings = ".nii.gz, .nii, .nrrd, .mha or .dcm";

/// Writes labels on their grid, by the file name's ending: NIfTI and MetaImage keep the numbers; NRRD (3D Slicer's
/// segmentation fields) also names and colours; DICOM segmentations names and colours, with segments numbered from 1.
/// Written beside and renamed: never half a file. Throws Error, Cancelled.
void writeLabels(const LabelMap& labels, const std::filesystem::path& path, const LabelOutput& output = {},
                 const Progress& progress = {});

}  // namespace fenestra::io
