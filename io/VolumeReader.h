#pragma once
// One call opens any volume: a DICOM folder or file, NIfTI, NRRD, MetaImage, MGH, Analyze, an archive of
// these, or raw bytes with a description.

#include <filesystem>
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
/// Opens a volume. Voxel values come out exactly as the format defines them, geometry in LPS mm. Throws Error,
/// Cancelled.
OpenedVolume openVolume(const std::filesystem::path& path, const OpenOptions& options = {});

/// Opens a label map (NRRD incl. Slicer's segment fields, or another format of volumes), a DICOM segmentation or a
/// structure set, alone or in an archive ("study.zip/kidney.nrrd"), and resamples it to `target` by nearest label when
/// its grid differs. Names come from the file, or from a table of "value name" lines beside it: the file's own name
/// with .txt or .tsv, or labels.tsv. `allowOutside` as in OpenOptions. Throws Error, Cancelled.
OpenedLabels openLabels(const std::filesystem::path& path, const Grid& target, const Progress& progress = {},
                        bool allowOutside = false);
/// The files that hold a label map: the named one, and those that its header names. Throws Error.
std::vector<std::filesystem::path> labelFiles(const std::filesystem::path& path, bool allowOutside = false);

}  // namespace fenestra::io
