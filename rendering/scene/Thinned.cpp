#include "rendering/scene/Thinned.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

/// Adds a row of a block's voxels to sums and counts of the blocks that they belong to.
template <class T>
void addRow(const T* row, int width, int factor, std::vector<double>& sums, std::vector<int>& counts) {
  for (int x = 0; x < width; ++x) {
    const double value = static_cast<double>(row[x]);
    if constexpr (std::is_floating_point_v<T>)
      if (!std::isfinite(value)) continue;
    const auto block = static_cast<std::size_t>(x / factor);
    sums[block] += value;
    ++counts[block];
  }
}

template <class T>
T meanOf(double sum, int count) {
  if constexpr (std::is_floating_point_v<T>)
    return count == 0 ? std::numeric_limits<T>::quiet_NaN() : static_cast<T>(sum / count);
  else
    return static_cast<T>(std::round(sum / count));
}

}  // namespace

Grid thinned(const Grid& grid, glm::ivec3 factor) {
  Grid result = grid;
  result.dims = (grid.dims + factor - 1) / factor;
  result.spacing = grid.spacing * glm::dvec3(factor);
  result.origin = glm::dvec3(grid.worldFromIndex() * glm::dvec4(0.5 * glm::dvec3(factor - 1), 1.0));
  return result;
}

std::shared_ptr<const Volume> thinned(const ShownVolume& shown, glm::ivec3 factor) {
  const Volume& volume = *shown.volume;
  const ShownVoxels voxels(shown);
  auto result = std::make_shared<Volume>();
  result->grid = thinned(volume.grid, factor);
  result->slope = volume.slope;
  result->intercept = volume.intercept;
  result->modality = volume.modality;
  result->unit = volume.unit;
  result->lowIsWhite = volume.lowIsWhite;
  result->windows = volume.windows;
  result->voxels = Voxels(volume.voxels.type(), result->grid.voxelCount());
  const glm::ivec3 from = volume.grid.dims, to = result->grid.dims;
  volume.voxels.visit([&](auto scalars) {
    using T = std::remove_const_t<typename decltype(scalars)::element_type>;
    T* out = result->voxels.as<T>().data();
    parallelFor(static_cast<std::size_t>(to.z), 1, [&](std::size_t begin, std::size_t end) {
      std::vector<double> sums(static_cast<std::size_t>(to.x));
      std::vector<int> counts(sums.size());
      std::vector<T> buffer;
      for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
        for (int y = 0; y < to.y; ++y) {
          std::fill(sums.begin(), sums.end(), 0.0);
          std::fill(counts.begin(), counts.end(), 0);
          for (int fz = z * factor.z; fz < std::min((z + 1) * factor.z, from.z); ++fz)
            for (int fy = y * factor.y; fy < std::min((y + 1) * factor.y, from.y); ++fy)
              addRow(voxels.row(fy, fz, buffer), from.x, factor.x, sums, counts);
          T* row = out + result->grid.offset({0, y, z});
          for (std::size_t x = 0; x < sums.size(); ++x) row[x] = meanOf<T>(sums[x], counts[x]);
        }
    });
  });
  result->range = volume.range;
  return result;
}

std::shared_ptr<const LabelMap> thinned(const LabelMap& labels, glm::ivec3 factor) {
  auto result = std::make_shared<LabelMap>();
  result->grid = thinned(labels.grid, factor);
  result->labels = labels.labels;
  result->voxels = Voxels(labels.voxels.type(), result->grid.voxelCount());
  const glm::ivec3 to = result->grid.dims;
  labels.voxels.visit([&](auto scalars) {
    using T = std::remove_const_t<typename decltype(scalars)::element_type>;
    T* out = result->voxels.as<T>().data();
    parallelFor(static_cast<std::size_t>(to.z), 1, [&](std::size_t begin, std::size_t end) {
      for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
        for (int y = 0; y < to.y; ++y)
          for (int x = 0; x < to.x; ++x) {
            const glm::ivec3 middle = glm::min(glm::ivec3(x, y, z) * factor + factor / 2, labels.grid.dims - 1);
            *(out + result->grid.offset({x, y, z})) = scalars[labels.grid.offset(middle)];
          }
    });
  });
  return result;
}

}  // namespace fenestra
