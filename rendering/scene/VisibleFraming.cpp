#include "rendering/scene/VisibleFraming.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <type_traits>

#include "rendering/scene/ShownVolume.h"
#include "rendering/scene/VisibleValues.h"
#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

/// Voxels are looked at in blocks; a block with few visible voxels is noise in the air.
struct Blocks {
  int side = 1;          ///< voxels
  int rowStep = 1;       ///< of large blocks, every other row is looked at
  int leastVisible = 1;  ///< of the voxels looked at

  explicit Blocks(glm::ivec3 dims) {
    const int longest = std::max({dims.x, dims.y, dims.z});
    if (longest >= 192)
      *this = Blocks(4, 2, 6);  // of 32
    else if (longest >= 96)
      *this = Blocks(2, 1, 2);  // of 8
  }

 private:
  Blocks(int a, int b, int c) : side(a), rowStep(b), leastVisible(c) {}
};

/// Twice the area of a triangle; positive when it turns left.
long long turn(glm::ivec2 a, glm::ivec2 b, glm::ivec2 c) {
  const glm::ivec2 u = b - a, v = c - a;
  return static_cast<long long>(u.x) * v.y - static_cast<long long>(u.y) * v.x;
}

/// The convex hull of points in the plane (Andrew 1979, the monotone chain).
std::vector<glm::ivec2> hullOf(std::vector<glm::ivec2> points) {
  std::sort(points.begin(), points.end(),
            [](glm::ivec2 a, glm::ivec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<glm::ivec2> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t begin = hull.size();
    for (const glm::ivec2 point : points) {
      while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();  // the other half begins with it
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// Corners of the hull of one layer of blocks, in voxels from the grid's first corner.
std::vector<glm::ivec2> layerHull(const std::vector<std::uint8_t>& counts, const Blocks& block, glm::ivec2 blocks,
                                  glm::ivec2 end) {
  std::vector<glm::ivec2> corners;
  for (int y = 0; y < blocks.y; ++y) {
    const auto row = counts.begin() + static_cast<std::ptrdiff_t>(y) * blocks.x, rowEnd = row + blocks.x;
    const auto shows = [&](std::uint8_t count) { return count >= block.leastVisible; };
    const auto first = std::find_if(row, rowEnd, shows);
    if (first == rowEnd) continue;
    auto last = rowEnd - 1;
    while (!shows(*last)) --last;
    for (const int j : {y * block.side, std::min((y + 1) * block.side, end.y)}) {
      corners.emplace_back(static_cast<int>(first - row) * block.side, j);
      corners.emplace_back(std::min(static_cast<int>(last - row + 1) * block.side, end.x), j);
    }
  }
  return hullOf(std::move(corners));
}

}  // namespace

Grid visibleGrid(const ShownVolume& of, const TransferFunction& context) {
  constexpr double leastShare = 0.01;  // of the fullest slab
  ShownVolume shown = of;
  shown.removed = nullptr;  // cameras do not move with what is carved away
  const Volume& volume = *shown.volume;
  const Grid& grid = volume.grid;
  const ShownVoxels voxels(shown);
  std::array<std::vector<std::size_t>, 3> counts;
  for (int axis = 0; axis < 3; ++axis)
    counts[static_cast<std::size_t>(axis)].resize(static_cast<std::size_t>(grid.dims[axis]));
  std::mutex mutex;
  volume.voxels.visit([&](auto scalars) {
    using T = std::remove_const_t<typename decltype(scalars)::value_type>;
    const VisibleValues<T> shows(volume, context);
    parallelFor(static_cast<std::size_t>(grid.dims.z), 4, [&](std::size_t begin, std::size_t end) {
      auto local = counts;
      std::vector<T> buffer;
      for (auto& axis : local) std::fill(axis.begin(), axis.end(), std::size_t{0});
      // Every other row is enough to find the extent.
      for (std::size_t z = begin; z < end; ++z)
        for (int y = static_cast<int>(z % 2); y < grid.dims.y; y += 2) {
          const T* row = voxels.row(y, static_cast<int>(z), buffer);
          std::size_t inRow = 0;
          for (int x = 0; x < grid.dims.x; ++x) {
            const std::size_t count = shows(row[x]);
            local[0][static_cast<std::size_t>(x)] += count;
            inRow += count;
          }
          local[1][static_cast<std::size_t>(y)] += inRow;
          local[2][z] += inRow;
        }
      const std::scoped_lock lock(mutex);
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < counts[axis].size(); ++i) counts[axis][i] += local[axis][i];
    });
  });
  Grid visible = grid;
  glm::ivec3 first(0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<std::size_t>& slabs = counts[static_cast<std::size_t>(axis)];
    const double least = leastShare * static_cast<double>(*std::max_element(slabs.begin(), slabs.end()));
    const auto counted = [&](std::size_t count) { return count > 0 && static_cast<double>(count) >= least; };
    const auto low = std::find_if(slabs.begin(), slabs.end(), counted);
    if (low == slabs.end()) return grid;
    const auto high = std::find_if(slabs.rbegin(), slabs.rend(), counted);
    first[axis] = static_cast<int>(low - slabs.begin());
    visible.dims[axis] = static_cast<int>(slabs.rend() - high) - first[axis];
  }
  visible.origin = glm::dvec3(grid.worldFromIndex() * glm::dvec4(glm::dvec3(first), 1.0));
  return visible;
}

Framing visibleFraming(const ShownVolume& of, const TransferFunction& context) {
  ShownVolume shown = of;
  shown.removed = nullptr;  // cameras do not move with what is carved away
  const Grid box = visibleGrid(shown, context);
  const Volume& volume = *shown.volume;
  const ShownVoxels voxels(shown);
  const Grid& grid = volume.grid;
  const glm::ivec3 first(glm::round(glm::dvec3(grid.indexFromWorld() * glm::dvec4(box.origin, 1.0))));
  const Blocks block(box.dims);
  const glm::ivec3 blocks = (box.dims + block.side - 1) / block.side;
  std::vector<std::vector<glm::ivec2>> hulls(static_cast<std::size_t>(blocks.z));
  volume.voxels.visit([&](auto scalars) {
    using T = std::remove_const_t<typename decltype(scalars)::value_type>;
    const VisibleValues<T> shows(volume, context);
    parallelFor(hulls.size(), 1, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint8_t> counts(static_cast<std::size_t>(blocks.x) * static_cast<std::size_t>(blocks.y));
      std::vector<T> buffer;
      for (std::size_t layer = begin; layer < end; ++layer) {
        std::fill(counts.begin(), counts.end(), std::uint8_t{0});
        const int low = static_cast<int>(layer) * block.side, high = std::min(low + block.side, box.dims.z);
        for (int z = low; z < high; ++z)
          for (int y = z % block.rowStep; y < box.dims.y; y += block.rowStep) {
            const T* row = voxels.row(first.y + y, first.z + z, buffer) + first.x;
            auto into = counts.begin() + static_cast<std::ptrdiff_t>(y / block.side) * blocks.x;
            for (int x = 0; x < box.dims.x; ++into)
              for (const int stop = std::min(x + block.side, box.dims.x); x < stop; ++x)
                *into = static_cast<std::uint8_t>(*into + shows(row[x]));
          }
        hulls[layer] = layerHull(counts, block, {blocks.x, blocks.y}, glm::ivec2(box.dims));
      }
    });
  });
  std::vector<glm::dvec3> points;
  for (std::size_t layer = 0; layer < hulls.size(); ++layer)
    for (const int z :
         {static_cast<int>(layer) * block.side, std::min(static_cast<int>(layer + 1) * block.side, box.dims.z)})
      for (const glm::ivec2 corner : hulls[layer])  // voxels reach half a step beyond their centres
        points.emplace_back(box.worldFromIndex() * glm::dvec4(glm::dvec3(corner, z) - 0.5, 1.0));
  if (points.empty()) return box;
  return {box.centre(), std::move(points)};
}

}  // namespace fenestra
