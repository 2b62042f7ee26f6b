#include "viewer/exports/PictureFile.h"

#include <cstdint>
#include <vector>

namespace fenestra::viewer {

void writePng(const QImage& picture, const std::filesystem::path& path, const std::optional<io::PngText>& text) {
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  const auto row = static_cast<std::size_t>(rgb.width()) * 3;
  std::vector<std::uint8_t> pixels;
  pixels.reserve(row * static_cast<std::size_t>(rgb.height()));
  for (int y = 0; y < rgb.height(); ++y) pixels.insert(pixels.end(), rgb.constScanLine(y), rgb.constScanLine(y) + row);
  io::writePng(path, {rgb.width(), rgb.height()}, 3, pixels, text);
}

}  // namespace fenestra::viewer
