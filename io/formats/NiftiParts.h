#pragma once
// What NIfTI-1 has from Analyze 7.5: numbers of data types, and pairs of a header and an image file.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "io/base/VoxelSink.h"
#include "io/formats/ImageFile.h"

namespace fenestra::io {

/// The scalar type that a header's `datatype` names; empty for colours, complex numbers, bits and unknown numbers.
std::optional<ElementType> niftiElementType(int datatype);

/// Lengths of the axes 1 to 7 by their numbers, given dim[0] and dim[1..7] as stored. Axes beyond dim[0] have length 1;
/// so, with a warning, has an axis from the third on of length 0 behind which all have 0 or 1: writers leave out what
/// they do not use (nifti_clib reads it so, too). Throws Error for a negative length, or another axis of length 0 from
/// the fourth on.
std::array<std::int64_t, 8> axisLengths(ImageFile& image, const std::array<std::int64_t, 8>& dim);

/// Whether a file is named as the image of a pair: ".img" or ".img.gz".
bool isPairImage(const std::filesystem::path& path);

/// A pair's other file: `path` with `extension` (".hdr" or ".img") in place of its own, ".gz" kept or not, as it
/// exists.
std::filesystem::path pairPartner(const std::filesystem::path& path, const std::string& extension);

/// Makes `file` the one that holds the voxels, plain or as gzip. Throws Error when it does not exist.
void setVoxelFile(ImageFile& image, const std::filesystem::path& file);

}  // namespace fenestra::io
