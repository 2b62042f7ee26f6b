#pragma once
// Empty-space skipping: the volume's cells in bricks.
//
// Cell frame: index + 1. Cell c spans [c, c+1] between voxel centres, half cells at the border included, so a side of n
// voxels has n + 1 cells. Brick b holds cells s·b … s·b + s - 1, s the side.

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "rendering/scene/ShownVolume.h"

namespace fenestra {

/// In cells. On the scans of tests/bench, rays take a quarter to a third fewer samples than with twice the side.
inline constexpr int brickSide = 4;
inline constexpr std::size_t cellsPerBrick = std::size_t{brickSide} * brickSide * brickSide;

/// A box of voxels, both ends included.
struct IndexBox {
  glm::ivec3 low{0}, high{0};
};
/// Makes `box` hold [low, high] too.
void grow(std::optional<IndexBox>& box, glm::ivec3 low, glm::ivec3 high);

/// Bricks along each axis of a volume of `dims` voxels.
glm::ivec3 brickCount(glm::ivec3 dims);
std::size_t brickOffset(glm::ivec3 bricks, glm::ivec3 brick);
/// A cell's place within its brick, x fastest.
std::size_t cellInBrick(glm::ivec3 cell);

/// Least and greatest real value at the corners of each brick's cells; the trilinear field inside a brick lies between
/// them. Non-finite voxels count as the volume's least value (NaN) or its range's ends (±Inf).
struct BrickRanges {
  glm::ivec3 dims{0};
  std::vector<ValueRange> ranges;  ///< x fastest
};
BrickRanges brickRanges(const ShownVolume& shown);

/// For each brick the Chebyshev distance, in bricks, to the nearest one with `occupied` ≠ 0; 0 in those, at most 255.
/// All bricks nearer than that are empty.
std::vector<std::uint8_t> chebyshevDistance(glm::ivec3 dims, const std::vector<std::uint8_t>& occupied);

}  // namespace fenestra
