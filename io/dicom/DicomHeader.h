#pragma once
// Reads the headers of DICOM files, without pixels.

#include <filesystem>

#include "io/base/Reading.h"
#include "io/dicom/DicomFile.h"

namespace fenestra::io {

/// Throws Error when the file is no DICOM file or its header is damaged.
DicomFile readDicomHeader(const std::filesystem::path& path);

}  // namespace fenestra::io
