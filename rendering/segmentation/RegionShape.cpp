#include "rendering/segmentation/RegionShape.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <numbers>
#include <vector>

#include "rendering/segmentation/BoneVoxels.h"
#include "rendering/segmentation/Morphology.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/segmentation/VoxelSet.h"
#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

constexpr double cellsAcross = 24.0;  ///< along a cube of the region's volume
/// Sides of a cell, at least: an irregular surface has depths that rise no farther than this.
constexpr double leastRise = 2.0;

VoxelBox shapeBox(std::span<const Level> joins, int step, const VoxelBox& whole) {
  VoxelBox box{whole.high, whole.low};
  std::mutex mutex;
  parallelFor(static_cast<std::size_t>(whole.high.z), 1, [&](std::size_t begin, std::size_t end) {
    VoxelBox own{whole.high, whole.low};
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      for (int y = 0; y < whole.high.y; ++y) {
        const auto row = joins.subspan(whole.offset({0, y, z}), static_cast<std::size_t>(whole.high.x));
        const auto isHeld = [step](Level level) { return level < step; };
        const auto first = std::ranges::find_if(row, isHeld);
        if (first == row.end()) continue;
        const auto last = std::find_if(row.rbegin(), row.rend(), isHeld);
        own.low = glm::min(own.low, glm::ivec3(static_cast<int>(first - row.begin()), y, z));
        own.high = glm::max(own.high, glm::ivec3(static_cast<int>(row.rend() - last), y + 1, z + 1));
      }
    const std::scoped_lock lock(mutex);
    box = {glm::min(box.low, own.low), glm::max(box.high, own.high)};
  });
  return box;
}

/// The region in cells of several voxels each, of which the middle one counts.
struct CoarseRegion {
  Grid grid;
  glm::ivec3 low{0}, stride{1};  ///< of the voxels that count
  std::vector<std::uint8_t> holds;
};

CoarseRegion coarseRegion(const Grid& grid, std::span<const Level> joins, int step, const VoxelBox& box,
                          double volume) {
  CoarseRegion region;
  const double length = std::cbrt(volume) / cellsAcross;
  for (int axis = 0; axis < 3; ++axis)
    region.stride[axis] = std::clamp(static_cast<int>(length / grid.spacing[axis] + 1e-6), 1, grid.dims[axis]);
  // Where the volume goes on, a layer of cells around the region is outside it.
  const VoxelBox seen = box.grownBy(2 * region.stride).clippedTo(wholeOf(grid.dims));
  region.low = seen.low + region.stride / 2;
  region.grid = grid;
  region.grid.dims = glm::max(glm::ivec3(1), seen.dims() / region.stride);
  region.grid.spacing = grid.spacing * glm::dvec3(region.stride);
  const VoxelBox cells = wholeOf(region.grid.dims);
  region.holds.resize(cells.count());
  for (std::size_t i = 0; i < region.holds.size(); ++i)
    region.holds[i] = joins[grid.offset(region.low + cells.at(i) * region.stride)] < step ? 1 : 0;
  return region;
}

/// How deep the part is that a cell lies in: from cell to the deepest one within its ball, while that is deeper.
double depthOfPart(const CoarseRegion& region, const VoxelSet& cells, std::span<const float> depths,
                   std::uint32_t number) {
  const VoxelBox whole = wholeOf(region.grid.dims);
  for (bool rises = true; rises;) {
    rises = false;
    const double depth = static_cast<double>(depths[number]);
    const glm::ivec3 at = whole.at(cells.offsets()[number]);
    for (const glm::ivec3 offset : ballOffsets(region.grid, std::max(depth, leastRise * voxelSide(region.grid)))) {
      if (!whole.contains(at + offset) || !cells.holds(whole.offset(at + offset))) continue;
      const std::uint32_t other = cells.numberOf(whole.offset(at + offset));
      if (depths[other] <= depths[number]) continue;
      number = other;
      rises = true;
    }
  }
  return static_cast<double>(depths[number]);
}

std::uint32_t nearestCell(const CoarseRegion& region, const VoxelSet& cells, glm::ivec3 seed) {
  const VoxelBox whole = wholeOf(region.grid.dims);
  const glm::dvec3 index = glm::dvec3(seed - region.low) / glm::dvec3(region.stride);
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t number = 0; number < cells.size(); ++number) {
    const double away = glm::length((glm::dvec3(whole.at(cells.offsets()[number])) - index) * region.grid.spacing);
    if (away >= least) continue;
    least = away;
    nearest = number;
  }
  return nearest;
}

double compactnessOf(const CoarseRegion& region, const VoxelSet& cells) {
  const VoxelBox whole = wholeOf(region.grid.dims);
  double area = 0.0;
  for (const std::uint32_t offset : cells.offsets())
    for (int axis = 0; axis < 3; ++axis)
      for (const int way : {-1, 1}) {
        glm::ivec3 next = whole.at(offset);
        next[axis] += way;
        if (whole.contains(next) && !cells.holds(whole.offset(next)))
          area += region.grid.voxelVolume() / region.grid.spacing[axis];
      }
  const double volume = static_cast<double>(cells.size()) * region.grid.voxelVolume();
  return area > 0.0 ? std::min(1.0, std::cbrt(36.0 * std::numbers::pi * volume * volume) / area) : 1.0;
}

}  // namespace

RegionShape shapeOf(const Grid& grid, std::span<const Level> joins, int step, double volume, glm::ivec3 seed) {
  const VoxelBox box = shapeBox(joins, step, wholeOf(grid.dims));
  if (box.empty()) return {};
  const CoarseRegion region = coarseRegion(grid, joins, step, box, volume);
  const VoxelSet cells(region.holds);
  if (cells.size() == 0) return {};
  const std::vector<float> depths = depthsOf(cells, region.grid);
  const double deepest = static_cast<double>(*std::max_element(depths.begin(), depths.end()));
  const double own = depthOfPart(region, cells, depths, nearestCell(region, cells, seed));
  return {own > 0.0 ? deepest / own : 1.0, compactnessOf(region, cells)};
}

}  // namespace fenestra::segmentation
