#pragma once
// Volumes to disk as other programs read them.

#include <filesystem>

#include "rendering/scene/Volume.h"

namespace fenestra::io {

/// Writes real values (after rescale) in the narrowest type that holds them, LPS geometry: .mha, .nii.gz, .nii or .nrrd
/// by the file name's ending. Written beside and renamed: never half a file. Throws Error.
void writeVolume(const Volume& volume, const std::filesystem::path& path);

}  // namespace fenestra::io
