#pragma once
// The tissues of a volume, found once for all clicks: cells of even value, merged two by two until one is left.
//
// The merges form a binary tree (P. Salembier, L. Garrido: Binary partition tree as an efficient representation for
// image processing, segmentation, and information retrieval, IEEE Transactions on Image Processing 9(4), 2000). Its
// leaves are the basins of the gradient. Two neighbours merge at the cost
//
//   (|difference of their means| + edge) · min(1, √(least volume / 2 ml)) / share^0.35
//
// edge: the mean over their common faces of how far the values on both sides differ; share: the common faces' part of
// the surface of the one that has less. All of the border decides, where a flood passes through its weakest voxel; what
// is small joins its neighbours before it can be told apart from noise, and two bodies that touch in a neck stay two.
// The cheapest pair merges first; a pair whose cost has risen meanwhile waits for its turn. The program's own formula.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "rendering/segmentation/Levels.h"
#include "rendering/segmentation/MergeTree.h"
#include "rendering/segmentation/TissueCells.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

struct Tissues;

class TissueTree {
 public:
  /// Takes about 60 bytes a cell while it runs, some twelve afterwards, and up to one byte a voxel once seeds have
  /// come. `goOn` is asked now and then with the share done; null when it returned false. Deterministic.
  static std::shared_ptr<const TissueTree> build(const Volume& volume, const std::function<bool(double)>& goOn = {});

  /// The levels at which voxels join a region that starts at the voxel `seed`: that of the least merge which holds
  /// both; 0 in the seed's own leaf. A pocket that a region encloses and that is less than half as large joins with
  /// what encloses it: marrow belongs to its bone, vessels to their lung. A cell on a border holds voxels of several
  /// leaves: each belongs to the leaf among those around it whose mean is nearest to its own value, smoothed. Costs are
  /// in units of the noise. Entry i is of voxel i of the volume. Runs on all cores.
  ///
  /// A cell may hold voxels of several leaves. `From::Cell` starts with the leaf of the seed's cell, which a noisy
  /// voxel does not change, `From::Voxel` with the one that holds the seed, so that the region of every level does.
  enum class From : std::uint8_t { Cell, Voxel };
  std::vector<Level> joinsOf(const Volume& volume, glm::ivec3 seed, From from = From::Cell) const;

  double noiseUnit() const { return noise_.unit; }   ///< real values
  double bodyVolume() const { return bodyVolume_; }  ///< mm³ of what is no air
  std::size_t heldBytes() const;

 private:
  void setNeighbours(const Tissues& tissues);
  std::uint32_t leafAt(const Volume& volume, glm::ivec3 voxel, From from) const;
  ToneScale voxelScale(const Volume& volume) const;
  std::span<const std::uint32_t> neighboursOf(std::uint32_t leaf) const;
  /// By leaf: the level that encloses it, which is its own where nothing does: of the ways from it to a face of the
  /// volume, the one that joins last; on a way its first leaf to join counts.
  std::vector<Level> enclosures(std::span<const Level> joins) const;
  void fillPockets(std::vector<Level>& joins) const;
  /// visit(offset of a voxel, its leaf) for all voxels, on all cores. `areAlike` tells of two leaves that it does not
  /// matter which of them holds a voxel.
  template <class AreAlike, class Visit>
  void forVoxels(const Volume& volume, AreAlike areAlike, Visit visit) const;
  template <class AreAlike, class Visit>
  void forTile(const Volume& volume, const ToneScale& scale, std::size_t number, AreAlike areAlike, Visit visit) const;

  glm::ivec3 cellSize_{1};  ///< voxels
  glm::ivec3 cells_{0};     ///< cells along each axis
  Noise noise_;
  double reference_ = 0.0, bodyVolume_ = 0.0;
  std::vector<std::uint32_t> leaves_;          ///< by cell
  std::vector<float> means_;                   ///< by leaf: tone
  std::vector<float> volumes_;                 ///< by leaf, mm³
  std::vector<std::uint8_t> isAtFace_;         ///< by leaf: whether it touches a face of the volume
  std::vector<std::uint32_t> firstNeighbour_;  ///< by leaf, and one more: where its neighbours begin
  std::vector<std::uint32_t> neighbours_;
  MergeTree merges_;
  /// By tile of cells, and voxel in it: which of the cells around the voxel's own has the leaf that holds it. Filled as
  /// tiles are asked about, because the next seed nearby asks again. One thread writes a tile.
  mutable std::vector<std::vector<std::uint8_t>> places_;
};

}  // namespace fenestra::segmentation
