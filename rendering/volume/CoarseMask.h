#pragma once
// A set of voxels in cells of a coarser grid, a bit a cell.

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra {

/// Each cell joins `stride` voxels along each axis; the last cell of an axis may have fewer.
struct CoarseMask {
  glm::ivec3 stride{1}, dims{0};
  std::vector<bool> cells;  ///< x fastest; true: the cell's voxels are in the set
  std::size_t count = 0;    ///< of cells in the set

  bool contains(glm::ivec3 voxel) const { return cells[rowOf(voxel.y, voxel.z) + cellOf(voxel.x)]; }
  /// Calls use(begin, end) for the cells of a row of `width` voxels, [begin, end) each, in order.
  template <class F>
  void forEachCell(int y, int z, int width, F&& use) const {
    const std::size_t row = rowOf(y, z);
    for (int x = 0; x < dims.x; ++x)
      if (cells[row + static_cast<std::size_t>(x)]) use(x * stride.x, std::min((x + 1) * stride.x, width));
  }

 private:
  std::size_t cellOf(int x) const { return static_cast<std::size_t>(x / stride.x); }
  std::size_t rowOf(int y, int z) const {
    return static_cast<std::size_t>(dims.x) *
           (static_cast<std::size_t>(y / stride.y) +
            static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(z / stride.z));
  }
};

}  // namespace fenestra
