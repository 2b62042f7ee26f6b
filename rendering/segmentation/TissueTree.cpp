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
glm::ivec3 tilesOf(glm::ivec3 cells) { return (cells + tileCells - 1) / tileCells; }

/// No place in places_: it is not found yet.
constexpr std::uint8_t unknown = 255;

/// The cells around a cell, itself among them: their places run from 0 to 26.
glm::ivec3 atPlace(std::uint8_t place) { return glm::ivec3(place % 3, place / 3 % 3, place / 9) - 1; }

/// The leaves of a cell and of those around it.
class NearLeaves {
 public:
  NearLeaves(const std::vector<std::uint32_t>& leaves, const std::vector<float>& means, const VoxelBox& cells,
             glm::ivec3 cell) {
    for (std::uint8_t place = 0; place < 27; ++place) {
      if (!cells.contains(cell + atPlace(place))) continue;
      const std::uint32_t leaf = leaves[cells.offset(cell + atPlace(place))];
      if (std::find(leaves_.begin(), leaves_.begin() + count_, leaf) != leaves_.begin() + count_) continue;
      leaves_[static_cast<std::size_t>(count_)] = leaf;
      places_[static_cast<std::size_t>(count_)] = place;
      means_[static_cast<std::size_t>(count_++)] = means[leaf];
    }
  }

  /// The first place of the one whose mean is nearest; the first of several.
  std::uint8_t nearestTo(float tone) const {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < static_cast<std::size_t>(count_); ++i)
      if (std::abs(means_[i] - tone) < std::abs(means_[nearest] - tone)) nearest = i;
    return places_[nearest];
  }

 private:
  std::array<std::uint32_t, 27> leaves_{};
  std::array<std::uint8_t, 27> places_{};
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
  tree->merges_ = std::move(*merges);
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
  std::size_t places = 0;
  for (const std::vector<std::uint8_t>& tile : places_) places += tile.size();
  return places + leaves_.size() * sizeof(std::uint32_t) + means_.size() * (2 * sizeof(float) + sizeof(std::uint8_t)) +
         firstNeighbour_.size() * sizeof(std::uint32_t) + neighbours_.size() * sizeof(std::uint32_t) +
         merges_.heldBytes();
}

std::uint32_t TissueTree::leafAt(const Volume& volume, glm::ivec3 voxel, From from) const {
  const VoxelBox cells = wholeOf(cells_);
  const glm::ivec3 cell = voxel / cellSize_;
  if (from == From::Cell || cellSize_ == glm::ivec3(1)) return leaves_[cells.offset(cell)];
  const ToneScale scale = voxelScale(volume);
  const float tone = smoothedTones(volume, {voxel, voxel + 1}, scale).front();
  return leaves_[cells.offset(cell + atPlace(NearLeaves(leaves_, means_, cells, cell).nearestTo(tone)))];
}

ToneScale TissueTree::voxelScale(const Volume& volume) const {
  return {volume, {noiseOf(volume).deviation, noise_.unit}, reference_};
}

std::span<const std::uint32_t> TissueTree::neighboursOf(std::uint32_t leaf) const {
  return std::span(neighbours_).subspan(firstNeighbour_[leaf], firstNeighbour_[leaf + 1] - firstNeighbour_[leaf]);
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
  const ToneScale scale = voxelScale(volume);
  places_.resize(wholeOf(tilesOf(cells_)).count());
  parallelFor(places_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t tile = begin; tile < end; ++tile) forTile(volume, scale, tile, areAlike, visit);
  });
}

template <class AreAlike, class Visit>
void TissueTree::forTile(const Volume& volume, const ToneScale& scale, std::size_t number, AreAlike areAlike,
                         Visit visit) const {
  const VoxelBox cells = wholeOf(cells_), voxels = wholeOf(volume.grid.dims);
  const glm::ivec3 low = wholeOf(tilesOf(cells_)).at(number) * tileCells;
  const VoxelBox tile = VoxelBox{low, low + tileCells}.clippedTo(cells);
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
  std::vector<std::uint8_t>& places = places_[number];
  if (places.empty()) places.assign(read.count(), unknown);
  std::array<std::ptrdiff_t, 27> away{};
  for (std::uint8_t place = 0; place < away.size(); ++place) {
    const glm::ivec3 step = atPlace(place);
    away[place] = step.x + cells_.x * (step.y + static_cast<std::ptrdiff_t>(cells_.y) * step.z);
  }
  std::vector<float> tones;  // only where the places of a cell on a border are unknown
  for (std::size_t c = 0; c < tile.count(); ++c) {
    const glm::ivec3 cell = tile.at(c);
    const std::uint32_t own = leaves_[cells.offset(cell)];
    const VoxelBox held = VoxelBox{cell * cellSize_, (cell + 1) * cellSize_}.clippedTo(voxels);
    if (allAlike(VoxelBox{cell - 1, cell + 2}.clippedTo(cells), own)) {
      visitAll(held, own);
      continue;
    }
    if (places[read.offset(held.low)] == unknown) {
      if (tones.empty()) tones = smoothedTones(volume, read, scale);
      const NearLeaves near(leaves_, means_, cells, cell);
      for (int z = held.low.z; z < held.high.z; ++z)
        for (int y = held.low.y; y < held.high.y; ++y)
          for (int x = held.low.x; x < held.high.x; ++x) {
            const std::size_t at = read.offset({x, y, z});
            places[at] = near.nearestTo(tones[at]);
          }
    }
    const std::uint32_t* const leaf = leaves_.data() + cells.offset(cell);
    for (int z = held.low.z; z < held.high.z; ++z)
      for (int y = held.low.y; y < held.high.y; ++y) {
        const std::size_t row = volume.grid.offset({held.low.x, y, z}), at = read.offset({held.low.x, y, z});
        for (std::size_t x = 0; x < static_cast<std::size_t>(held.dims().x); ++x)
          visit(row + x, leaf[away[places[at + x]]]);
      }
  }
}

std::vector<Level> TissueTree::joinsOf(const Volume& volume, glm::ivec3 seed, From from) const {
  std::vector<Level> byLeaf = merges_.joinsFrom(leafAt(volume, seed, from));
  byLeaf.resize(means_.size());  // leaves come first
  fillPockets(byLeaf);
  std::vector<Level> joins(volume.grid.voxelCount());
  forVoxels(
      volume, [&](std::uint32_t a, std::uint32_t b) { return byLeaf[a] == byLeaf[b]; },
      [&](std::size_t voxel, std::uint32_t leaf) { joins[voxel] = byLeaf[leaf]; });
  return joins;
}

}  // namespace fenestra::segmentation
