#pragma once
// Slices as files: a grey PNG under a window, or real values in their place in the patient.

#include <filesystem>
#include <vector>

#include "rendering/volume/Slice.h"

namespace fenestra::cli {

/// Whether the file's name asks for real values: it ends in .mha.
bool isValueFile(const std::filesystem::path& file);

/// float32, first row on top; TransformMatrix, Offset and ElementSpacing are the slice's, LPS. NaN stays NaN.
void writeValues(const std::filesystem::path& file, const SliceGeometry& geometry, int slice,
                 const std::vector<float>& values);

/// What is no number is black.
void writeGrey(const std::filesystem::path& file, glm::ivec2 size, const std::vector<float>& values, WindowLevel window,
               bool lowIsWhite);

}  // namespace fenestra::cli
