#pragma once
// TIFF files of known content, written with libtiff tag by tag.

#include <filesystem>
#include <string>
#include <vector>

namespace fenestra::tests {

struct TiffSpec {
  int width = 2, height = 3, pages = 4;
  int bits = 16, sampleFormat = 1;  ///< 1: unsigned, 2: signed, 3: float
  int samples = 1, photometric = 1;
  int compression = 1;     ///< 1: none, 5: LZW, 8: deflate, 32773: PackBits
  bool tiled = false;      ///< in tiles of 16 x 16
  std::string mode = "w";  ///< libtiff's: wl, wb: byte orders; w8: BigTIFF
  std::string description = {};
  double resolution = 0.0;  ///< pixels per unit; 0: none
  int unit = 1;             ///< 1: none, 2: inch, 3: centimetre
  int orientation = 1;
  int thumbnails = 0;  ///< pages of one pixel behind the others, said to be reduced images
  int first = 0;       ///< the first value; values count on, page after page
};
void writeTiff(const std::filesystem::path& path, const TiffSpec& spec);

/// `spec`'s values, page after page.
std::vector<double> tiffValues(const TiffSpec& spec);

}  // namespace fenestra::tests
