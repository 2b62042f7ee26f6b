#pragma once
// DICOM files and folders as volumes.

#include <filesystem>
#include <vector>

#include "io/base/Reading.h"

namespace fenestra::io {

std::vector<SeriesInfo> listDicomSeries(const std::filesystem::path& path, const OpenOptions& options);
/// The slices that openDicom() would open, without decoding pixels: those whose pixels are damaged, too.
ListedSlices listDicomSlices(const std::filesystem::path& path, const OpenOptions& options);
OpenedVolume openDicom(const std::filesystem::path& path, const OpenOptions& options);

}  // namespace fenestra::io
