#pragma once
// A folder of masks, one file a structure, as TotalSegmentator writes them by default.

#include <filesystem>
#include <vector>

#include "io/base/LabelReading.h"

namespace fenestra::io {

/// The volume files of a folder, in their natural order; not those of the folders in it. Empty where the
/// folder cannot be listed.
std::vector<std::filesystem::path> maskFiles(const std::filesystem::path& folder);

/// The masks of a folder as one label map on `target`: labels are numbered from 1 in the files' natural order and named
/// after the files. A voxel is in a structure where its mask holds anything but 0. Where structures overlap, the
/// smaller one stays (LabelOverlap). Files that are no masks (they hold several values), or cannot be read, are left
/// out and said. Throws Error when none is left; Cancelled.
LabelsOnGrid readMaskFolder(const std::filesystem::path& folder, const Grid& target, const Progress& progress,
                            bool allowOutside);

}  // namespace fenestra::io
