#pragma once
// Volumes to disk as other programs read them.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "rendering/volume/Volume.h"

namespace fenestra::io {

/// Key/value pairs of a NRRD header, their values escaped.
using NrrdFields = std::vector<std::pair<std::string, std::string>>;
struct NrrdOptions {
  NrrdFields nrrdFields = {};
  bool packNrrd = false;  ///< gzip encoding: label maps shrink to a hundredth
};

/// Writes real values (after rescale) in the narrowest type that holds them, LPS geometry: .mha, .nii.gz, .nii or .nrrd
/// by the file name's ending. `options` are for .nrrd alone. Written beside and
/// renamed: never half a file. Throws Error.
void writeVolume(const Volume& volume, const std::filesystem::path& path, const NrrdOptions& options = {});
/// As writeVolume(), but always float32, which keeps what is no number.
void writeFloats(const Volume& volume, const std::filesystem::path& path);

}  // namespace fenestra::io
