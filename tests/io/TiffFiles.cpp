#include "tests/io/TiffFiles.h"

#include <tiffio.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "tests/io/IoTesting.h"

namespace fenestra::tests {
namespace {

/// `count` scalars from `first` on.
std::string scalars(const TiffSpec& spec, int first, int count) {
  std::string bytes;
  for (int i = first; i < first + count; ++i) {
    if (spec.sampleFormat == 3)
      bytes += spec.bits == 64 ? bytesOf(static_cast<double>(i)) : bytesOf(static_cast<float>(i));
    else if (spec.bits == 32)
      bytes += bytesOf(static_cast<std::int32_t>(i));
    else if (spec.bits == 16)
      bytes += bytesOf(static_cast<std::int16_t>(i));
    else
      bytes += static_cast<char>(i);
  }
  return bytes;
}

void writeRows(TIFF* file, const TiffSpec& spec, int first) {
  const int row = spec.width * spec.samples;
  for (int y = 0; y < spec.height; ++y) {
    std::string bytes = scalars(spec, first + y * row, row);
    if (TIFFWriteScanline(file, bytes.data(), static_cast<std::uint32_t>(y), 0) != 1) throw std::runtime_error("TIFF");
  }
}

void writeTiles(TIFF* file, const TiffSpec& spec, int first) {
  constexpr int side = 16;
  const std::size_t scalar = static_cast<std::size_t>(spec.bits) / 8;
  for (int top = 0; top < spec.height; top += side)
    for (int left = 0; left < spec.width; left += side) {
      std::string tile(side * side * scalar, '\0');
      for (int y = 0; y < side && top + y < spec.height; ++y) {
        const int columns = std::min(side, spec.width - left);
        const std::string bytes = scalars(spec, first + (top + y) * spec.width + left, columns);
        std::memcpy(tile.data() + static_cast<std::size_t>(y) * side * scalar, bytes.data(), bytes.size());
      }
      if (TIFFWriteTile(file, tile.data(), static_cast<std::uint32_t>(left), static_cast<std::uint32_t>(top), 0, 0) < 0)
        throw std::runtime_error("TIFF");
    }
}

void setTags(TIFF* file, const TiffSpec& spec) {
  TIFFSetField(file, TIFFTAG_IMAGEWIDTH, spec.width);
  TIFFSetField(file, TIFFTAG_IMAGELENGTH, spec.height);
  TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, spec.bits);
  TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, spec.samples);
  TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, spec.sampleFormat);
  TIFFSetField(file, TIFFTAG_PHOTOMETRIC, spec.photometric);
  TIFFSetField(file, TIFFTAG_PLANARCONFIG, 1);
  TIFFSetField(file, TIFFTAG_COMPRESSION, spec.compression);
  TIFFSetField(file, TIFFTAG_ORIENTATION, spec.orientation);
  if (spec.tiled) {
    TIFFSetField(file, TIFFTAG_TILEWIDTH, 16);
    TIFFSetField(file, TIFFTAG_TILELENGTH, 16);
  } else {
    TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, 2);
  }
  if (spec.photometric == 3) {
    std::vector<std::uint16_t> map(256, 7);
    TIFFSetField(file, TIFFTAG_COLORMAP, map.data(), map.data(), map.data());
  }
  if (spec.resolution > 0.0) {
    TIFFSetField(file, TIFFTAG_XRESOLUTION, spec.resolution);
    TIFFSetField(file, TIFFTAG_YRESOLUTION, spec.resolution);
    TIFFSetField(file, TIFFTAG_RESOLUTIONUNIT, spec.unit);
  }
}

}  // namespace

void writeTiff(const std::filesystem::path& path, const TiffSpec& spec) {
  const std::unique_ptr<TIFF, void (*)(TIFF*)> file(TIFFOpen(path.c_str(), spec.mode.c_str()), TIFFClose);
  if (!file) throw std::runtime_error("cannot write " + path.string());
  const int each = spec.width * spec.height * spec.samples;
  for (int page = 0; page < spec.pages; ++page) {
    setTags(file.get(), spec);
    if (page == 0 && !spec.description.empty())
      TIFFSetField(file.get(), TIFFTAG_IMAGEDESCRIPTION, spec.description.c_str());
    if (spec.tiled)
      writeTiles(file.get(), spec, spec.first + page * each);
    else
      writeRows(file.get(), spec, spec.first + page * each);
    TIFFWriteDirectory(file.get());
  }
  TiffSpec thumbnail = spec;
  thumbnail.width = thumbnail.height = 1;
  thumbnail.tiled = false;
  for (int i = 0; i < spec.thumbnails; ++i) {
    setTags(file.get(), thumbnail);
    TIFFSetField(file.get(), TIFFTAG_SUBFILETYPE, FILETYPE_REDUCEDIMAGE);
    writeRows(file.get(), thumbnail, 99);
    TIFFWriteDirectory(file.get());
  }
}

std::vector<double> tiffValues(const TiffSpec& spec) {
  std::vector<double> values;
  for (int i = 0; i < spec.width * spec.height * spec.pages; ++i) values.push_back(spec.first + i);
  return values;
}

}  // namespace fenestra::tests
