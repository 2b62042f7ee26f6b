#include "viewer/exports/PictureFile.h"

#include <cstdint>
#include <vector>

namespace fenestra::viewer {

void writePng(const QImage& picture, const std::filesystem::path& path, const std::vector<io::PngText>& texts) {
  const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
  const auto row = static_cast<std::size_t>(rgb.width()) * 3;
  std::vector<std::uint8_t> pixels;
  pixels.reserve(row * static_cast<std::size_t>(rgb.height()));
  for (int y = 0; y < rgb.height(); ++y) pixels.insert(pixels.end(), rgb.constScanLine(y), rgb.constScanLine(y) + row);
  io::writePng(path, {rgb.width(), rgb.height()}, 3, pixels, texts);
}

io::PngText textOf(const QStringList& fidelity) {
  QString text = fidelity.join(QLatin1Char('\n'));
  // The text of a PNG is ASCII here.
  for (const auto& [from, to] : {std::pair(u'×', "x"), std::pair(u'≤', "<="), std::pair(u'³', "3")})
    text.replace(QChar(from), QLatin1String(to));
  return {"Fidelity", text.toLatin1().replace('\0', ' ').toStdString()};
}

}  // namespace fenestra::viewer
