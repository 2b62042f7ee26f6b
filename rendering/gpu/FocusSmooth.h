#pragma once
// The smoothed indicator of a label focus, whose gradients are the normals of its surface.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rendering/gpu/FocusIndex.h"

namespace fenestra {

/// The box of voxels that a smoothed indicator covers; low ends and sizes are multiples of FocusSmooth::tileSide, so
/// that the box seldom changes while the focus does, and sizes are no powers of two. Size 0: none.
struct SmoothBox {
  glm::ivec3 origin{0};  ///< index of the first voxel
  glm::ivec3 size{0};
  bool operator==(const SmoothBox&) const = default;
};

/// 0 outside the focus and 65535 inside (eight bits would show as facets in the normals), or the index's smoothed
/// indicator, filtered by the binomials of
/// 8 along each axis: a Gaussian of σ = √2 voxels. Beyond the volume its edge is repeated. Made tile by tile.
class FocusSmooth {
 public:
  static constexpr int tileSide = 16;  ///< voxels: a tile with what is read around it fits a core's first cache
  static constexpr std::size_t tileVoxels = std::size_t{tileSide} * tileSide * tileSide;
  using Tile = std::array<std::uint16_t, tileVoxels>;  ///< x fastest

  /// `index` is of labels of a volume of `dims`, and must outlive this.
  FocusSmooth(const FocusIndex& index, glm::ivec3 dims);

  /// All voxels that the filter can reach, with one more for gradients.
  const SmoothBox& box() const { return box_; }
  /// First voxels of the tiles that hold other than 0, x fastest.
  std::vector<glm::ivec3> tiles() const;
  /// First voxels of the tiles that depend on those bricks, which are offsets; see brickOffset().
  std::vector<glm::ivec3> tilesNear(const std::vector<std::size_t>& bricks) const;
  /// Filters a tile.
  void make(glm::ivec3 tile, Tile& voxels) const;

 private:
  static constexpr int reach = 4;  ///< voxels: a filter of nine taps
  static constexpr int blockSide = tileSide + 2 * reach;
  /// Whether the voxels that a tile depends on are in the focus: bit x of row y + blockSide · z.
  using Bits = std::array<std::uint32_t, static_cast<std::size_t>(blockSide* blockSide)>;

  glm::ivec3 tileCount() const { return box_.size / tileSide; }
  std::vector<glm::ivec3> marked(const std::vector<std::uint8_t>& marks) const;
  void read(glm::ivec3 tile, Bits& bits) const;
  /// make() for labels with a smoothed indicator.
  void makeSmoothed(glm::ivec3 tile, Tile& voxels) const;
  /// Repeats the voxels at the border of the volume in a block whose first voxel is `low`.
  void repeatEdge(glm::ivec3 low, Bits& bits) const;

  const FocusIndex& index_;
  glm::ivec3 dims_;
  SmoothBox box_;
};

}  // namespace fenestra
