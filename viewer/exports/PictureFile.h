#pragma once
// Writes pictures of the window to files.

#include <filesystem>
#include <optional>

#include <QImage>

#include "io/ImageWriter.h"

namespace fenestra::viewer {

/// 8-bit RGB, without alpha. Throws io::Error.
void writePng(const QImage& picture, const std::filesystem::path& path, const std::optional<io::PngText>& text = {});

}  // namespace fenestra::viewer
