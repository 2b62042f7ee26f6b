#include "io/Thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/VolumeReader.h"
#include "rendering/volume/Slice.h"

namespace fenestra::io {
namespace {

/// The anatomical plane that the volume's slices are nearest to.
SlicePlane planeOf(const Grid& grid) {
  const glm::dvec3 normal = glm::abs(grid.direction[2]);
  if (normal.z >= normal.x && normal.z >= normal.y) return SlicePlane::Axial;
  return normal.x > normal.y ? SlicePlane::Sagittal : SlicePlane::Coronal;
}

/// Means of the pixels under each pixel of the smaller picture.
Thumbnail reduced(const std::vector<std::uint8_t>& grey, glm::ivec2 from, glm::ivec2 size) {
  Thumbnail small{size, std::vector<std::uint8_t>(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y))};
  const auto begin = [](int i, int count, int of) { return static_cast<int>(std::int64_t{i} * of / count); };
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const int x0 = begin(x, size.x, from.x), x1 = std::max(begin(x + 1, size.x, from.x), x0 + 1);
      const int y0 = begin(y, size.y, from.y), y1 = std::max(begin(y + 1, size.y, from.y), y0 + 1);
      std::int64_t sum = 0;
      for (int row = y0; row < y1; ++row)
        for (int column = x0; column < x1; ++column)
          sum +=
              grey[static_cast<std::size_t>(row) * static_cast<std::size_t>(from.x) + static_cast<std::size_t>(column)];
      small.grey[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)] =
          static_cast<std::uint8_t>(sum / (std::int64_t{x1 - x0} * (y1 - y0)));
    }
  return small;
}

}  // namespace

Thumbnail makeThumbnail(const SeriesInfo& series, int side, const Progress& progress) {
  if (series.files.empty()) throw Error(series.id, "has no files", "open the study again");
  OpenOptions options;
  options.progress = progress;
  const std::filesystem::path& file = series.files[series.files.size() / 2];
  // One file may hold several series, such as time points.
  for (const SeriesInfo& inside : listSeries(file))
    if (inside.id == series.id) options.series = series.id;
  const OpenedVolume opened = openVolume(file, options);
  const Volume& volume = *opened.volume;
  const SliceGeometry slice = sliceGeometry(volume.grid, planeOf(volume.grid));
  const std::vector<std::uint8_t> grey =
      windowed(sliceValues(volume, slice, slice.count / 2), volume.defaultWindow(), volume.lowIsWhite);
  const glm::dvec2 millimetres(slice.width * glm::length(slice.right), slice.height * glm::length(slice.down));
  const glm::dvec2 size = glm::round(millimetres * (side / std::max(millimetres.x, millimetres.y)));
  return reduced(grey, {slice.width, slice.height}, glm::clamp(glm::ivec2(size), glm::ivec2(1), glm::ivec2(side)));
}

}  // namespace fenestra::io
