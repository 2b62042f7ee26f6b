#pragma once
// Pages of TIFF files (TIFF Revision 6.0; BigTIFF), read with libtiff, which stays private to TiffFile.cpp.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/base/ByteStream.h"
#include "io/base/VoxelSink.h"

namespace fenestra::io {

/// What the tags of a page (an image file directory) say.
struct TiffPage {
  std::uint64_t place = 0;  ///< of the directory in its file
  std::uint32_t width = 0, height = 0;
  ElementType type = ElementType::UInt8;
  bool whiteIsZero = false;  ///< stored values count from white to black
  bool hasPalette = false;   ///< values are numbers of colours
  bool isCompressed = false;
  std::uint64_t firstStrip = 0;             ///< place of its first strip
  double xResolution = 0, yResolution = 0;  ///< pixels per unit; 0: not said
  int resolutionUnit = 2;                   ///< 1: none, 2: inch, 3: centimetre
  int orientation = 1;                      ///< 1: the first row is on top, the first column left

  std::uint64_t bytes() const { return std::uint64_t{width} * height * sizeOf(type); }
};

struct TiffDirectory {
  std::vector<TiffPage> pages;  ///< without thumbnails and masks
  std::string description;      ///< ImageDescription of the first page
  bool bigEndian = false;
};

/// The pages of a file. Throws Error for a damaged file, and for pages of colours or other numbers than 8, 16, 32 or 64
/// bits.
TiffDirectory readTiffPages(const std::filesystem::path& path);

/// A page of a file.
struct TiffPageOf {
  std::filesystem::path file;
  TiffPage page;
};
/// The scalars of all `pages`, page after page in this machine's byte order, from byte `begin` on. All pages are of one
/// size and type.
std::unique_ptr<ByteStream> openTiffPages(std::vector<TiffPageOf> pages, std::uint64_t begin);

}  // namespace fenestra::io
