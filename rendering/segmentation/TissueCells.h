#pragma once
// A volume as cells of whole voxels, which tissues are made of.

#include <array>
#include <cstdint>
#include <vector>

#include "rendering/segmentation/Smoothing.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

inline constexpr double gasBelow = -400.0;  ///< HU

/// Cells of a voxel each, or, in volumes of more than three million, of several, as even in mm as these allow. Those at
/// the far ends may hold fewer voxels.
struct TissueCells {
  Grid grid;
  glm::ivec3 size{1};        ///< voxels along the sides of a cell
  Noise noise;               ///< of the cells' means
  double reference = 0.0;    ///< the real value whose tone is 0
  double bodyVolume = 0.0;   ///< mm³ of what is no air
  std::vector<float> tones;  ///< smoothed means with sharp edges, see ToneScale, x fastest
};

TissueCells tissueCells(const Volume& volume);

/// Which cells lie side by side.
class CellNeighbours {
 public:
  explicit CellNeighbours(const Grid& grid);

  /// visit(cell, the next one along the axis, axis, index of the cell) for all pairs of neighbours.
  template <class Visit>
  void forPairs(Visit visit) const {
    std::size_t at = 0;
    for (int z = 0; z < dims_.z; ++z)
      for (int y = 0; y < dims_.y; ++y)
        for (int x = 0; x < dims_.x; ++x, ++at) {
          const glm::ivec3 index(x, y, z);
          for (int axis = 0; axis < 3; ++axis)
            if (index[axis] + 1 < dims_[axis]) visit(at, at + step(axis), axis, index);
        }
  }
  std::size_t step(int axis) const { return steps_[static_cast<std::size_t>(axis)]; }
  glm::ivec3 dims() const { return dims_; }
  double faceArea(int axis) const { return faceArea_[axis]; }  ///< mm²

 private:
  glm::ivec3 dims_;
  std::array<std::size_t, 3> steps_;
  glm::dvec3 faceArea_{0.0};
};

/// Basins of the tones' gradient, which each cell reaches by steepest descent (J. Fairfield: Toboggan contrast
/// enhancement for contrast segmentation, ICPR 1990).
struct Basins {
  std::vector<std::uint32_t> numbers;  ///< by cell
  std::uint32_t count = 0;
};
Basins basinsOf(const std::vector<float>& tones, const CellNeighbours& cells);

}  // namespace fenestra::segmentation
