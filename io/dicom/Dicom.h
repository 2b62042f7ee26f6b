#pragma once
// DICOM files and folders as volumes.

#include <filesystem>
#include <vector>

#include "io/base/FileStart.h"
#include "io/base/Reading.h"

namespace fenestra::io {

/// Whether a file holds a DICOM dataset, with or without the preamble.
bool looksLikeDicom(const FileStart& start);
std::vector<SeriesInfo> listDicomSeries(const std::filesystem::path& path, const OpenOptions& options);
OpenedVolume openDicom(const std::filesystem::path& path, const OpenOptions& options);

}  // namespace fenestra::io
