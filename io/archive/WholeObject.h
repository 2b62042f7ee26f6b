#pragma once
// Whether the file of an object that came is one dataset and no more. Include in .cpp files alone.

#include <filesystem>

#include "io/dicom/Dcmtk.h"

namespace fenestra::io::archive {

/// False where the file ends within its pixels or holds something else behind its dataset, as where a line between lost
/// or repeated bytes; zeros at the end are padding. `header` is what loadHeader() read of the file.
bool isWholeObject(DcmDataset& header, const std::filesystem::path& file);

}  // namespace fenestra::io::archive
