#include "rendering/segmentation/TissueTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "rendering/segmentation/TissueMerger.h"
#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

/// Cells that share one look at the volume's voxels: their intermediate arrays fit a core's cache.
constexpr glm::ivec3 tileCells{32, 8, 8};

/// The leaves of a cell and of those around it.
class NearLeaves {
 public:
  NearLeaves(const std::vector<std::uint32_t>& leaves, const std::vector<float>& means, const VoxelBox& cells,
             const VoxelBox& around) {
    for (int z = around.low.z; z < around.high.z; ++z)
      for (int y = around.low.y; y < around.high.y; ++y)
        for (int x = around.low.x; x < around.high.x; ++x) {
          const std::uint32_t leaf = leaves[cells.offset({x, y, z})];
          if (std::find(leaves_.begin(), leaves_.begin() + count_, leaf) != leaves_.begin() + count_) continue;
          leaves_[static_cast<std::size_t>(count_)] = leaf;
          means_[static_cast<std::size_t>(count_++)] = means[leaf];
        }
  }

  /// By its mean; the first of several.
  std::uint32_t nearestTo(float tone) const {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < static_cast<std::size_t>(count_); ++i)
      if (std::abs(means_[i] - tone) < std::abs(means_[nearest] - tone)) nearest = i;
    return leaves_[nearest];
  }

 private:
  std::array<std::uint32_t, 27> leaves_{};
  std::array<float, 27> means_{};
  std::ptrdiff_t count_ = 0;
};

}  // namespace

std::shared_ptr<const TissueTree> TissueTree::build(const Volume& volume, const std::function<bool(double)>& goOn) {
  const auto tree = std::make_shared<TissueTree>();
  TissueCells cells = tissueCells(volume);
  if (goOn && !goOn(0.2)) return nullptr;
  tree->cellSize_ = cells.size;
  tree->cells_ = cells.grid.dims;
  tree->noise_ = cells.noise;
  tree->reference_ = cells.reference;
  tree->bodyVolume_ = cells.bodyVolume;
  Basins basins = basinsOf(cells.tones, CellNeighbours(cells.grid));
  Tissues tissues = tissuesOf(cells, basins);
  tree->isAtFace_.assign(tissues.all.size(), 0);
  const VoxelBox whole = wholeOf(tree->cells_), inner = whole.grownBy(glm::ivec3(-1));
  for (std::size_t i = 0; i < basins.numbers.size(); ++i)
    if (!inner.contains(whole.at(i))) tree->isAtFace_[basins.numbers[i]] = 1;
  for (const Tissue& tissue : tissues.all) {
    tree->means_.push_back(static_cast<float>(tissue.mean()));
    tree->volumes_.push_back(static_cast<float>(tissue.volume));
  }
  tree->setNeighbours(tissues);
  tree->leaves_ = std::move(basins.numbers);
  if (goOn && !goOn(0.4)) return nullptr;
  std::optional<MergeTree> merges =
      mergeTissues(std::move(tissues), [&](double share) { return !goOn || goOn(0.4 + 0.6 * share); });
  if (!merges) return nullptr;
  tree->parents_ = std::move(merges->parents);
  tree->heights_ = std::move(merges->heights);
  return tree;
}

void TissueTree::setNeighbours(const Tissues& tissues) {
  firstNeighbour_.assign(tissues.all.size() + 1, 0);
  for (const TissueContact& contact : tissues.contacts)
    for (const std::uint32_t each : {contact.a, contact.b}) ++firstNeighbour_[each + 1];
  std::partial_sum(firstNeighbour_.begin(), firstNeighbour_.end(), firstNeighbour_.begin());
  neighbours_.resize(2 * tissues.contacts.size());
  std::vector<std::uint32_t> next(firstNeighbour_.begin(), firstNeighbour_.end() - 1);
  for (const TissueContact& contact : tissues.contacts) {
    neighbours_[next[contact.a]++] = contact.b;
    neighbours_[next[contact.b]++] = contact.a;
  }
}

std::size_t TissueTree::heldBytes() const {
  return leaves_.size() * sizeof(std::uint32_t) + means_.size() * (2 * sizeof(float) + sizeof(std::uint8_t)) +
         firstNeighbour_.size() * sizeof(std::uint32_t) + neighbours_.size() * sizeof(std::uint32_t) +
         parents_.size() * (sizeof(std::uint32_t) + sizeof(float));
}

std::uint32_t TissueTree::leafAt(glm::ivec3 voxel) const { return leaves_[wholeOf(cells_).offset(voxel / cellSize_)]; }

std::span<const std::uint32_t> TissueTree::neighboursOf(std::uint32_t leaf) const {
  return std::span(neighbours_).subspan(firstNeighbour_[leaf], firstNeighbour_[leaf + 1] - firstNeighbour_[leaf]);
}

std::vector<Level> TissueTree::leafJoins(glm::ivec3 seed) const {
  std::vector<Level> joins(parents_.size(), never);
  for (std::uint32_t node = leafAt(seed); node != none; node = parents_[node]) joins[node] = levelOf(heights_[node]);
  for (std::size_t node = parents_.size(); node-- > 0;)
    if (joins[node] == never && parents_[node] != none) joins[node] = joins[parents_[node]];
  joins.resize(means_.size());
  return joins;
}

std::vector<Level> TissueTree::enclosures(std::span<const Level> joins) const {
  std::vector<Level> greatest(joins.size(), 0);
  std::array<std::vector<std::uint32_t>, 256> waiting;
  const auto begin = [&](std::uint32_t leaf) {
    greatest[leaf] = joins[leaf];
    waiting[joins[leaf]].push_back(leaf);
  };
  for (std::uint32_t leaf = 0; leaf < joins.size(); ++leaf)
    if (isAtFace_[leaf]) begin(leaf);
  for (std::size_t level = waiting.size(); level-- > 1;)
    for (std::size_t i = 0; i < waiting[level].size(); ++i) {
      const std::uint32_t leaf = waiting[level][i];
      if (greatest[leaf] != level) continue;
      for (const std::uint32_t next : neighboursOf(leaf)) {
        const Level along = std::min(static_cast<Level>(level), joins[next]);
        if (along <= greatest[next]) continue;
        greatest[next] = along;
        waiting[along].push_back(next);
      }
    }
  return greatest;
}

void TissueTree::fillPockets(std::vector<Level>& joins) const {
  const std::vector<Level> enclosed = enclosures(joins);
  std::array<double, 256> volumes{};
  for (std::size_t leaf = 0; leaf < joins.size(); ++leaf) volumes[joins[leaf]] += static_cast<double>(volumes_[leaf]);
  for (std::size_t level = 1; level < volumes.size(); ++level) volumes[level] += volumes[level - 1];
  std::vector<std::uint8_t> seen(joins.size(), 0);
  std::vector<std::uint32_t> pocket;
  for (std::uint32_t first = 0; first < joins.size(); ++first) {
    if (seen[first] || enclosed[first] >= joins[first]) continue;
    const Level level = enclosed[first];
    double volume = 0.0;
    pocket.assign(1, first);
    seen[first] = 1;
    for (std::size_t i = 0; i < pocket.size(); ++i) {
      volume += static_cast<double>(volumes_[pocket[i]]);
      for (const std::uint32_t next : neighboursOf(pocket[i]))
        if (!seen[next] && enclosed[next] == level && joins[next] > level) {
          seen[next] = 1;
          pocket.push_back(next);
        }
    }
    if (volume < 0.5 * volumes[level])
      for (const std::uint32_t leaf : pocket) joins[leaf] = level;
  }
}

template <class AreAlike, class Visit>
void TissueTree::forVoxels(const Volume& volume, AreAlike areAlike, Visit visit) const {
  if (cellSize_ == glm::ivec3(1)) {
    for (std::size_t i = 0; i < leaves_.size(); ++i) visit(i, leaves_[i]);
    return;
  }
  const ToneScale scale(volume, {noiseOf(volume).deviation, noise_.unit}, reference_);
  const glm::ivec3 tiles = (cells_ + tileCells - 1) / tileCells;
  parallelFor(wholeOf(tiles).count(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const glm::ivec3 first = wholeOf(tiles).at(t) * tileCells;
      forTile(volume, scale, VoxelBox{first, first + tileCells}.clippedTo(wholeOf(cells_)), areAlike, visit);
    }
  });
}

template <class AreAlike, class Visit>
void TissueTree::forTile(const Volume& volume, const ToneScale& scale, const VoxelBox& tile, AreAlike areAlike,
                         Visit visit) const {
  const VoxelBox cells = wholeOf(cells_), voxels = wholeOf(volume.grid.dims);
  const VoxelBox read = VoxelBox{tile.low * cellSize_, tile.high * cellSize_}.clippedTo(voxels);
  const auto allAlike = [&](const VoxelBox& box, std::uint32_t leaf) {
    for (int z = box.low.z; z < box.high.z; ++z)
      for (int y = box.low.y; y < box.high.y; ++y) {
        const std::uint32_t* row = leaves_.data() + cells.offset({box.low.x, y, z});
        for (int x = 0; x < box.dims().x; ++x)
          if (!areAlike(row[x], leaf)) return false;
      }
    return true;
  };
  const auto visitAll = [&](const VoxelBox& box, std::uint32_t leaf) {
    for (int z = box.low.z; z < box.high.z; ++z)
      for (int y = box.low.y; y < box.high.y; ++y) {
        const std::size_t row = volume.grid.offset({box.low.x, y, z});
        for (std::size_t x = 0; x < static_cast<std::size_t>(box.dims().x); ++x) visit(row + x, leaf);
      }
  };
  const std::uint32_t any = leaves_[cells.offset(tile.low)];
  if (allAlike(tile.grownBy(glm::ivec3(1)).clippedTo(cells), any)) return visitAll(read, any);
  std::vector<float> tones;  // only where a cell of the tile is on a border
  for (std::size_t c = 0; c < tile.count(); ++c) {
    const glm::ivec3 cell = tile.at(c);
    const std::uint32_t own = leaves_[cells.offset(cell)];
    const VoxelBox around = VoxelBox{cell - 1, cell + 2}.clippedTo(cells);
    const VoxelBox held = VoxelBox{cell * cellSize_, (cell + 1) * cellSize_}.clippedTo(voxels);
    if (allAlike(around, own)) {
      visitAll(held, own);
      continue;
    }
    if (tones.empty()) tones = smoothedTones(volume, read, scale);
    const NearLeaves near(leaves_, means_, cells, around);
    for (int z = held.low.z; z < held.high.z; ++z)
      for (int y = held.low.y; y < held.high.y; ++y)
        for (int x = held.low.x; x < held.high.x; ++x)
          visit(volume.grid.offset({x, y, z}), near.nearestTo(tones[read.offset({x, y, z})]));
  }
}

std::vector<Level> TissueTree::joinsOf(const Volume& volume, glm::ivec3 seed) const {
  std::vector<Level> byLeaf = leafJoins(seed);
  fillPockets(byLeaf);
  std::vector<Level> joins(volume.grid.voxelCount());
  forVoxels(
      volume, [&](std::uint32_t a, std::uint32_t b) { return byLeaf[a] == byLeaf[b]; },
      [&](std::size_t voxel, std::uint32_t leaf) { joins[voxel] = byLeaf[leaf]; });
  return joins;
}

}  // namespace fenestra::segmentation
