#pragma once
// What NIfTI-1 has from Analyze 7.5: numbers of data types, and pairs of a header and an image file.

#include <filesystem>
#include <optional>
#include <string>

#include "io/base/VoxelSink.h"
#include "io/formats/ImageFile.h"

namespace fenestra::io {

/// The scalar type that a header's `datatype` names; empty for colours, complex numbers, bits and unknown numbers.
std::optional<ElementType> niftiElementType(int datatype);

/// Whether a file is named as the image of a pair: ".img" or ".img.gz".
bool isPairImage(const std::filesystem::path& path);

/// A pair's other file: `path` with `extension` (".hdr" or ".img") in place of its own, ".gz" kept or not, as it
/// exists.
std::filesystem::path pairPartner(const std::filesystem::path& path, const std::string& extension);

/// Makes `file` the one that holds the voxels, plain or as gzip. Throws Error when it does not exist.
void setVoxelFile(ImageFile& image, const std::filesystem::path& file);

}  // namespace fenestra::io
