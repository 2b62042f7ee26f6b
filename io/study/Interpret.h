#pragma once
// What several files mean that a user names at once.

#include <filesystem>
#include <vector>

#include "io/study/StudyRequest.h"

namespace fenestra::io {

/// Interprets files that the user dropped or named together. Files of one folder whose names are not those of whole
/// volumes are slices, so the folder is opened; otherwise one is the volume and the other its label map: a folder is a
/// volume, unless it holds masks and its name alone speaks of labels, and so is the first file unless its name alone
/// does. Several folders are opened as the folder that holds them and nothing else. `paths` must not be empty. Throws
/// Error for other combinations.
DataRequest interpret(const std::vector<std::filesystem::path>& paths);

/// Whether a path can be a label map's: a file, or a folder with volume files in it, as masks are.
bool mayBeLabels(const std::filesystem::path& path);

}  // namespace fenestra::io
