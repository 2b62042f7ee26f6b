#pragma once
// One call opens any volume: a DICOM folder or file, NIfTI, NRRD, MetaImage, MGH, Analyze, TIFF (a file or a
// folder of pages), an archive of these, or raw bytes with a description.

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "io/base/Error.h"
#include "io/base/Reading.h"
#include "io/base/VolumeEnding.h"

namespace fenestra::io {

/// "WxHxD:TYPE[:le|be][:skip=BYTES]", e.g. "256x256x128:uint16:be:skip=512". Throws Error.
RawDescription parseRawDescription(std::string_view text);

/// The series (or single volume with its time points) in PATH, without decoding pixels. Throws Error, Cancelled.
std::vector<SeriesInfo> listSeries(const std::filesystem::path& path, const OpenOptions& options = {});
/// The slices of the DICOM series that openVolume() would open, without decoding pixels: those whose pixels are
/// damaged, too. Empty for other formats and archives. Throws Error, Cancelled.
std::optional<ListedSlices> listSlices(const std::filesystem::path& path, const OpenOptions& options = {});
/// Opens a volume. Voxel values come out exactly as the format defines them, geometry in LPS mm. Throws Error,
/// Cancelled.
OpenedVolume openVolume(const std::filesystem::path& path, const OpenOptions& options = {});

}  // namespace fenestra::io
