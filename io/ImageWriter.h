#pragma once
// Pictures and layers to disk; written beside and renamed, never half a file.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra::io {

/// A text chunk (tEXt) of a PNG.
struct PngText {
  std::string keyword;  ///< 1 to 79 printable characters of ASCII
  std::string text;     ///< ASCII
};

/// 8-bit PNG, row by row from the top, `channels` 1 (grey), 3 (RGB) or 4 (RGBA, not premultiplied).
void writePng(const std::filesystem::path& path, glm::ivec2 size, int channels, std::span<const std::uint8_t> pixels,
              const std::vector<PngText>& texts = {});

/// 2-D MetaImage, float32, uncompressed, local data, `channels` interleaved, first row = top of the picture.
void writeLayer(const std::filesystem::path& path, glm::ivec2 size, int channels, std::span<const float> values);

/// A picture or a layer read back, as float; PNG channels scaled to 0..1. Throws Error.
struct Picture {
  glm::ivec2 size{0};
  int channels = 0;
  std::vector<float> values;
};
Picture readPicture(const std::filesystem::path& path);
/// The text chunks (tEXt) of a PNG, in their order; longer ones than a megabyte are left out. Throws Error.
std::vector<PngText> readPngTexts(const std::filesystem::path& path);

}  // namespace fenestra::io
