#pragma once
// A small picture of a series, to choose it by.

#include <cstdint>
#include <vector>

#include "io/base/Reading.h"

namespace fenestra::io {

struct Thumbnail {
  glm::ivec2 size{0};
  std::vector<std::uint8_t> grey;  ///< row by row from the top
};

/// The middle slice in the series' own plane, in its default window, at most `side` pixels wide and high with square
/// pixels. Of a DICOM series only the file in the middle is read. Throws Error, Cancelled.
Thumbnail makeThumbnail(const SeriesInfo& series, int side, const Progress& progress = {});

}  // namespace fenestra::io
