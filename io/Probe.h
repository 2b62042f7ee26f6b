#pragma once
// Which format a file is, by its content, and what every way of opening one has in common.

#include "io/formats/ImageFile.h"

namespace fenestra::io {

enum class Format { Dicom, Nifti, Nrrd, MetaImage, Mgh, Analyze, Tiff, Archive };

/// Throws Error for a path that is missing, empty, or neither a file nor a folder.
void checkExists(const std::filesystem::path& path);
/// Throws Error when no format fits.
Format formatOf(const std::filesystem::path& path);
/// Any format but Dicom and Archive. `allowOutside` and `spacing` as in OpenOptions.
ImageFile readImageHeader(const std::filesystem::path& path, Format format, bool allowOutside,
                          const std::optional<glm::dvec3>& spacing = {});
SeriesInfo describe(const ImageFile& image);

}  // namespace fenestra::io
