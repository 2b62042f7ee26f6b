#include "rendering/segmentation/BoneTree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "rendering/segmentation/BoneJoints.h"
#include "rendering/segmentation/BoneVoxels.h"
#include "rendering/segmentation/HounsfieldGuess.h"
#include "rendering/segmentation/Morphology.h"
#include "rendering/segmentation/PairQueue.h"
#include "rendering/segmentation/Smoothing.h"

namespace fenestra::segmentation {
namespace {

// Chosen on the marked structures of tests/bench/results/growing.md.
constexpr double neckUnit = 4.0;       ///< units of the noise: the cost of a neck of half the width
constexpr double gapWeight = 2.5;      ///< of BoneMeeting::gap(): 2 does nearly as well
constexpr double narrowestNeck = 0.3;  ///< parts with less in common are two bones at every tolerance
constexpr double closingRadius = 2.0;  ///< voxel sides
constexpr double nearHalf = 50.0;      ///< mm: farther away no bone's canal begins that holds a seed
constexpr double jointCost = 0.7;      ///< neck and gap: with more it is a joint, with less part of a bone
/// HU, and deviations of the noise: three in ten values of bone differ by more from their median, where those of blood
/// or tissue with a contrast agent do not.
constexpr double leastSpread = 45.0, leastNoiseSpread = 1.5, spreadQuantile = 0.7;

/// Basins of the depth, and the greatest depth at which two of them meet.
struct Watershed {
  std::vector<std::uint32_t> leaves;  ///< by voxel of the set
  std::vector<float> peaks;           ///< by leaf: its greatest depth, mm
  BoneMeetings meetings;              ///< by leaf; without gaps
};

/// From the deepest voxel on, each goes to the basin of its deepest neighbour.
Watershed watershedOf(const VoxelSet& voxels, const std::vector<float>& depths, const VoxelBox& whole) {
  constexpr std::uint32_t none = UINT32_MAX;
  std::vector<std::uint32_t> order(voxels.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return depths[a] > depths[b]; });
  Watershed result;
  result.leaves.assign(voxels.size(), none);
  const Neighbours neighbours(whole);
  std::vector<std::uint32_t> near;
  for (const std::uint32_t number : order) {
    near.clear();
    std::uint32_t steepest = none;  // the deepest of the neighbours that are deeper
    neighbours.visit(voxels.offsets()[number], [&](glm::ivec3, std::size_t offset) {
      if (!voxels.holds(offset)) return;
      const std::uint32_t other = voxels.numberOf(offset);
      const std::uint32_t leaf = result.leaves[other];
      if (leaf == none) return;
      if (steepest == none || depths[other] > depths[steepest]) steepest = other;
      if (std::find(near.begin(), near.end(), leaf) == near.end()) near.push_back(leaf);
    });
    const auto own = steepest == none ? static_cast<std::uint32_t>(result.peaks.size()) : result.leaves[steepest];
    if (steepest == none) {
      result.peaks.push_back(depths[number]);
      result.meetings.emplace_back();
    }
    result.leaves[number] = own;
    for (const std::uint32_t other : near)
      if (other != own) {
        result.meetings[own].try_emplace(other, BoneMeeting{depths[number]});
        result.meetings[other].try_emplace(own, BoneMeeting{depths[number]});
      }
  }
  return result;
}

/// Merges the parts with the widest neck and the least gap first.
class NeckMerger {
 public:
  NeckMerger(Watershed& watershed, double side)
      : peaks_(watershed.peaks), meetings_(watershed.meetings), slack_(0.5 * side) {
    tree.parents.assign(peaks_.size(), MergeTree::none);
    tree.heights.assign(peaks_.size(), 0.0f);
    for (std::uint32_t a = 0; a < meetings_.size(); ++a)
      for (const auto& [b, meeting] : meetings_[a])
        if (a < b) push(a, b, meeting);
    while (const std::optional<MergePair> pair = queue_.pop())
      if (tree.parents[pair->a] == MergeTree::none && tree.parents[pair->b] == MergeTree::none) merge(*pair);
  }

  MergeTree tree;

 private:
  void push(std::uint32_t a, std::uint32_t b, const BoneMeeting& meeting) {
    const double lesser = static_cast<double>(std::min(peaks_[a], peaks_[b]));
    const double width = meeting.depth + slack_ >= lesser ? 1.0 : meeting.depth / lesser;
    if (meeting.depth <= 0.0 || width < narrowestNeck) return;
    const double cost = neckUnit * (1.0 / width - 1.0 + gapWeight * meeting.gap());
    queue_.push({static_cast<float>(cost), std::min(a, b), std::max(a, b)});
  }

  void merge(const MergePair& pair) {
    const auto parent = static_cast<std::uint32_t>(tree.parents.size());
    tree.parents.push_back(MergeTree::none);
    tree.heights.push_back(std::max({pair.cost, tree.heights[pair.a], tree.heights[pair.b]}));
    tree.parents[pair.a] = tree.parents[pair.b] = parent;
    peaks_.push_back(std::max(peaks_[pair.a], peaks_[pair.b]));
    meetings_.emplace_back();
    std::unordered_map<std::uint32_t, BoneMeeting>& both = meetings_.back();
    for (const std::uint32_t part : {pair.a, pair.b}) {
      for (const auto& [other, meeting] : meetings_[part]) {
        meetings_[other].erase(part);
        if (other != pair.a && other != pair.b) both[other].add(meeting);
      }
      meetings_[part] = {};
    }
    for (const auto& [other, meeting] : both) {
      meetings_[other][parent] = meeting;
      push(other, parent, meeting);
    }
  }

  std::vector<float>& peaks_;
  BoneMeetings& meetings_;
  double slack_;  ///< mm
  PairQueue queue_;
};

/// Where a seed can lie around a dense voxel that a closing reaches it from.
std::vector<glm::ivec3> nearOffsets(const Grid& grid) {
  return ballOffsets(grid, 2.0 * closingRadius * voxelSide(grid));
}

/// The box of the voxels that join at all; empty without one.
VoxelBox boxOf(const VoxelSet& voxels, const std::vector<std::uint32_t>& leaves, const std::vector<Level>& joins,
               const VoxelBox& whole) {
  VoxelBox box{whole.high, whole.low};
  for (std::size_t number = 0; number < voxels.size(); ++number)
    if (joins[leaves[number]] != never) {
      const glm::ivec3 at = whole.at(voxels.offsets()[number]);
      box = {glm::min(box.low, at), glm::max(box.high, at + 1)};
    }
  return box;
}

}  // namespace

std::shared_ptr<const BoneTree> BoneTree::build(const Volume& volume, const std::optional<HounsfieldGuess>& guess,
                                                const std::function<bool()>& goOn) {
  assert(volume.grid.voxelCount() < UINT32_MAX);
  const auto tree = std::make_shared<BoneTree>();
  tree->grid_ = volume.grid;
  if (!volume.isInHounsfieldUnits()) {
    if (!guess) return nullptr;
    tree->scaled_ = inHounsfieldUnits(volume, *guess, wholeOf(volume.grid.dims));
  }
  tree->noise_ = noiseOf(tree->inUnits(volume));
  tree->voxels_ = boneVoxels(tree->inUnits(volume), tree->noise_);
  if (goOn && !goOn()) return nullptr;
  const std::vector<float> depths = depthsOf(tree->voxels_, volume.grid);
  if (goOn && !goOn()) return nullptr;
  Watershed watershed = watershedOf(tree->voxels_, depths, wholeOf(volume.grid.dims));
  if (goOn && !goOn()) return nullptr;
  if (!addGaps(tree->inUnits(volume), tree->noise_.deviation, tree->voxels_, watershed.leaves, watershed.meetings,
               goOn))
    return nullptr;
  if (goOn && !goOn()) return nullptr;
  NeckMerger merger(watershed, voxelSide(volume.grid));
  tree->leaves_ = std::move(watershed.leaves);
  tree->merges_ = std::move(merger.tree);
  return tree;
}

bool BoneTree::isNear(const Volume& volume, const std::optional<HounsfieldGuess>& guess, glm::ivec3 seed) {
  if (volume.isInHounsfieldUnits()) return isNearBone(volume, seed, nearOffsets(volume.grid));
  if (!guess) return false;
  const auto half = glm::ivec3(glm::ceil(nearHalf / volume.grid.spacing));
  const VoxelBox around = VoxelBox{seed - half, seed + half + 1}.clippedTo(wholeOf(volume.grid.dims));
  return isNearBone(*inHounsfieldUnits(volume, *guess, around), seed - around.low, nearOffsets(volume.grid));
}

/// The leaf of the nearest dense voxel that a closing could reach the seed from.
std::uint32_t BoneTree::leafNear(glm::ivec3 seed) const {
  const VoxelBox whole = wholeOf(grid_.dims);
  std::uint32_t nearest = none;
  double least = 0.0;
  for (const glm::ivec3 offset : nearOffsets(grid_)) {
    if (!whole.contains(seed + offset) || !voxels_.holds(whole.offset(seed + offset))) continue;
    const double distance = glm::length(glm::dvec3(grid_.worldFromIndex() * glm::dvec4(glm::dvec3(offset), 0.0)));
    if (nearest != none && distance >= least) continue;
    nearest = leaves_[voxels_.numberOf(whole.offset(seed + offset))];
    least = distance;
  }
  return nearest;
}

std::optional<std::vector<Level>> BoneTree::joinsOf(glm::ivec3 seed) const {
  const VoxelBox whole = wholeOf(grid_.dims);
  const std::uint32_t leaf = leafNear(seed);
  if (leaf == none) return std::nullopt;
  const std::vector<Level> byLeaf = merges_.joinsFrom(leaf);
  const std::vector<glm::ivec3> ball = ballOffsets(grid_, closingRadius * voxelSide(grid_));
  glm::ivec3 reach(0);
  for (const glm::ivec3 offset : ball) reach = glm::max(reach, offset);
  const VoxelBox box = boxOf(voxels_, leaves_, byLeaf, whole).grownBy(2 * reach).clippedTo(whole);
  if (!box.contains(seed)) return std::nullopt;
  std::vector<Level> levels(box.count(), never), least(box.count(), never);
  for (std::size_t number = 0; number < voxels_.size(); ++number)
    if (const Level level = byLeaf[leaves_[number]]; level != never)
      levels[box.offset(whole.at(voxels_.offsets()[number]))] = level;
  lowerToLeastWithin(levels, box.dims(), ball, least);
  const std::vector<Level> closed = greatestWithin(least, box.dims(), ball);
  const Level first = std::min(closed[box.offset(seed)], levels[box.offset(seed)]);
  if (first == never) return std::nullopt;
  std::vector<Level> joins(whole.count(), never);
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const Level level = std::min(closed[i], levels[i]);
    if (level != never) joins[whole.offset(box.at(i))] = std::max(first, level);
  }
  return joins;
}

int BoneTree::lastStep() { return levelOf(neckUnit * jointCost) + 1; }

bool BoneTree::isBone(const Volume& shown, std::span<const Level> joins, int step) const {
  const Volume& volume = inUnits(shown);
  std::vector<double> values;
  for (const std::uint32_t offset : voxels_.offsets())
    if (joins[offset] < step) values.push_back(volume.value(wholeOf(grid_.dims).at(offset)));
  if (values.empty()) return false;
  const auto quantile = [&](double share) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  const double median = quantile(0.5);
  for (double& value : values) value = std::abs(value - median);
  return quantile(spreadQuantile) >= std::max(leastSpread, leastNoiseSpread * noise_.deviation);
}

std::size_t BoneTree::heldBytes() const {
  return (scaled_ ? scaled_->voxels.byteCount() : 0) + voxels_.heldBytes() + leaves_.size() * sizeof(std::uint32_t) +
         merges_.heldBytes();
}

}  // namespace fenestra::segmentation
