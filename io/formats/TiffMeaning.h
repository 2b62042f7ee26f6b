#pragma once
// What a TIFF file's description and resolution say about a stack: voxels' size, and the order of pages of several
// channels or times. ImageJ's and OME's descriptions are text in ImageDescription.

#include <cstdint>
#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "io/formats/TiffFile.h"

namespace fenestra::io {

/// Pages of a stack of `slices` at each of `channels` and `times`. `order` has the letters Z, C and T, the one that
/// changes first in front.
struct TiffOrder {
  std::int64_t slices = 1, channels = 1, times = 1;
  std::string order = "CZT";
  std::int64_t images = 0;  ///< that the description counts; 0: it does not

  std::int64_t pages() const { return slices * channels * times; }
  /// The number of a page, from 0.
  std::int64_t pageOf(std::int64_t slice, std::int64_t channel, std::int64_t time) const;
};
/// The order that the description gives; empty where it gives none.
std::optional<TiffOrder> tiffOrder(const std::string& description);

struct TiffSpacing {
  glm::dvec3 millimetres{0.0};  ///< 0: not said
  std::string source;           ///< what says so, for a message
  std::string unknownUnit;      ///< of lengths; empty: there is none
  std::string printResolution;  ///< "72 pixels an inch", which tells nothing of voxels
};
/// What the first page and the description say about the size of voxels.
TiffSpacing tiffSpacing(const TiffPage& page, const std::string& description);

}  // namespace fenestra::io
