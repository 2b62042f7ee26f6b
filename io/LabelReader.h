#pragma once
// One call opens any label map.

#include <filesystem>
#include <vector>

#include "io/base/Error.h"
#include "io/base/Reading.h"

namespace fenestra::io {

/// Opens a label map (NRRD incl. Slicer's segment fields, or another format of volumes), a DICOM segmentation or a
/// structure set, alone or in an archive ("study.zip/kidney.nrrd"), or a folder of masks, one file a structure; and
/// resamples it to `target` by nearest label when its grid differs. Names and colours come from `table` where one is
/// named, from the file, or from a table beside it (LabelTable.h). `allowOutside` as in OpenOptions. Throws Error,
/// Cancelled.
OpenedLabels openLabels(const std::filesystem::path& path, const Grid& target, const Progress& progress = {},
                        bool allowOutside = false, const std::filesystem::path& table = {});
/// The files that hold a label map: the named one, and those that its header names. Throws Error.
std::vector<std::filesystem::path> labelFiles(const std::filesystem::path& path, bool allowOutside = false);

}  // namespace fenestra::io
