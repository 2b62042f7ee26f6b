#pragma once
// The indicator of labels with the steps of the voxels smoothed away.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rendering/settings/LabelSmoothing.h"
#include "rendering/volume/LabelMap.h"

namespace fenestra {

/// Voxels in tiles; a tile in which all are alike takes no memory.
struct TileMap {
  static constexpr int side = 8;  ///< voxels
  static constexpr std::size_t voxels = std::size_t{side} * side * side;

  glm::ivec3 dims{0};                ///< voxels
  glm::ivec3 count{0};               ///< tiles
  std::vector<std::uint32_t> slots;  ///< x fastest; 0 and 1: alike; n ≥ 2: number n - 2 of the others

  std::size_t offset(glm::ivec3 tile) const;
  /// Copies a block of values, of which each tile has `perSide` along each axis, from `low` on to `to`, x fastest;
  /// beyond the last one along an axis it is repeated. Tiles without elements in `values` are filled with one of
  /// `alike`, by their slot: the first where the slot is neither 0 nor 1.
  template <int perSide, class T>
  void read(const std::vector<T>& values, std::array<T, 2> alike, glm::ivec3 low, glm::ivec3 block, T* to) const;
};

/// A value in [0, 1] at every voxel, trilinear between their centres; the surface is its ½ level.
///
/// It is more than ½ at every voxel that has one of the labels and less at every other. So the surface crosses the
/// cells and the lines between voxel centres that the surface of the 0/1 indicator crosses, and no others: on each such
/// line it moves by less than half a voxel, and no structure is lost, not even a single voxel.
///
/// The 0/1 indicator diffuses under that condition. Whitaker ("Reducing aliasing artifacts in iso-surfaces of binary
/// volumes", IEEE Symposium on Volume Visualization 2000) holds a curvature flow by it in the same way. Diffusion alone
/// would shrink what is convex; hence after each step values are shifted so that the surface encloses as much volume as
/// the 0/1 indicator's, weighted by a Gaussian of σ = 4 voxels around, and at the end all by one amount for the whole
/// volume.
///
/// Smoothing is by voxels, whatever their spacing: the steps between thick slices are as long as those slices.
class SmoothedIndicator {
 public:
  static constexpr std::uint16_t one = 65535;

  /// `labels` are the ones in focus; `strength` is not Off. Runs on all cores and can be interrupted.
  SmoothedIndicator(const LabelMap& map, std::span<const std::uint16_t> labels, LabelSmoothing strength);

  /// In 65535ths; beyond the map its edge is repeated.
  std::uint16_t at(glm::ivec3 voxel) const;
  /// Values of `size` voxels from `low` on, x fastest, in 65535ths.
  void read(glm::ivec3 low, glm::ivec3 size, std::uint16_t* to) const;

 private:
  TileMap tiles_;
  std::vector<std::uint16_t> values_;
};

}  // namespace fenestra
