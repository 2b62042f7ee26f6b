#pragma once
// Writes pictures of the window to files.

#include <filesystem>
#include <vector>

#include <QImage>
#include <QStringList>

#include "io/ImageWriter.h"

namespace fenestra::viewer {

/// 8-bit RGB, without alpha. Throws io::Error.
void writePng(const QImage& picture, const std::filesystem::path& path, const std::vector<io::PngText>& texts = {});

/// How faithful the picture is and why, as the PNG's text "Fidelity".
io::PngText textOf(const QStringList& fidelity);

}  // namespace fenestra::viewer
