#include "rendering/segmentation/TissueMerger.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

namespace fenestra::segmentation {
namespace {

// Chosen on structures marked in tests/bench/results/growing.md, by the best Dice of any tolerance. A quarter of
// smallVolume changes it by 0.03 at most, four times as much costs a hip 0.14. A power of 0.5 costs an aorta 0.07, one
// of 0.25 a vertebra 0.27; organs hardly change.
constexpr double smallVolume = 2000.0;  ///< mm³: what is smaller merges at a lower cost
constexpr double sharePower = 0.35;
/// Of a difference over three faces, as that of a blurred edge.
constexpr float acrossShare = 0.7f;

float costOf(const Tissue& a, const Tissue& b, const TissueContact& contact) {
  const double size = std::min(1.0, std::sqrt(std::min(a.volume, b.volume) / smallVolume));
  const double share = std::min(1.0, contact.area / std::min(a.surface, b.surface));
  return static_cast<float>(edgeBetween(a, b, contact) * size / std::pow(share, sharePower));
}

class Merger {
 public:
  explicit Merger(std::vector<Tissue> tissues)
      : tissues_(std::move(tissues)), nodes_(tissues_.size()), tree_{std::vector(tissues_.size(), UINT32_MAX), {}} {
    tree_.heights.assign(tissues_.size(), 0.0f);
    std::iota(nodes_.begin(), nodes_.end(), std::uint32_t{0});
    owners_ = nodes_;
    for (std::uint32_t a = 0; a < tissues_.size(); ++a)
      for (const auto& [b, contact] : tissues_[a].contacts)
        if (a < b) push(a, b, contact);
  }

  std::optional<MergeTree> run(const std::function<bool(double)>& goOn) {
    const std::size_t leaves = tissues_.size();
    while (!waiting_.empty()) {
      const Pair pair = waiting_.top();
      waiting_.pop();
      const std::uint32_t a = ownerOf(pair.a), b = ownerOf(pair.b);
      if (a == b) continue;
      const float cost = costOf(tissues_[a], tissues_[b], tissues_[a].contacts.at(b));
      if (cost > pair.cost) {
        waiting_.push({cost, std::min(a, b), std::max(a, b)});
        continue;
      }
      merge(a, b, cost);
      const std::size_t merged = tree_.parents.size() - leaves;
      if (merged % 4096 == 0 && goOn && !goOn(static_cast<double>(merged) / static_cast<double>(leaves)))
        return std::nullopt;
    }
    return std::move(tree_);
  }

 private:
  struct Pair {
    float cost;
    std::uint32_t a, b;
    bool operator<(const Pair& other) const {  // the cheapest on top; ties by number
      return std::tie(other.cost, other.a, other.b) < std::tie(cost, a, b);
    }
  };

  void push(std::uint32_t a, std::uint32_t b, const TissueContact& contact) {
    waiting_.push({costOf(tissues_[a], tissues_[b], contact), std::min(a, b), std::max(a, b)});
  }

  /// The tissue that a merged one belongs to now.
  std::uint32_t ownerOf(std::uint32_t tissue) {
    while (owners_[tissue] != tissue) tissue = owners_[tissue] = owners_[owners_[tissue]];
    return tissue;
  }

  /// The one with fewer contacts goes into the other one.
  void merge(std::uint32_t a, std::uint32_t b, float cost) {
    if (tissues_[a].contacts.size() < tissues_[b].contacts.size()) std::swap(a, b);
    const auto parent = static_cast<std::uint32_t>(tree_.parents.size());
    tree_.heights.push_back(std::max({cost, tree_.heights[nodes_[a]], tree_.heights[nodes_[b]]}));
    tree_.parents.push_back(UINT32_MAX);
    tree_.parents[nodes_[a]] = tree_.parents[nodes_[b]] = parent;
    nodes_[a] = parent;
    owners_[b] = a;
    Tissue &kept = tissues_[a], &gone = tissues_[b];
    kept.surface += gone.surface - 2.0 * kept.contacts[b].area;
    kept.volume += gone.volume;
    kept.tones += gone.tones;
    kept.contacts.erase(b);
    gone.contacts.erase(a);
    for (const auto& [other, contact] : gone.contacts) {
      TissueContact& both = kept.contacts[other];
      both.area += contact.area;
      both.difference += contact.difference;
      tissues_[other].contacts.erase(b);
      tissues_[other].contacts[a] = both;
      push(a, other, both);
    }
    gone.contacts = {};
  }

  std::vector<Tissue> tissues_;
  std::vector<std::uint32_t> nodes_, owners_;  ///< by tissue
  MergeTree tree_;
  std::priority_queue<Pair> waiting_;
};

}  // namespace

std::vector<Tissue> tissuesOf(const TissueCells& cells, const Basins& basins) {
  std::vector<Tissue> tissues(basins.count);
  const double cellVolume = cells.grid.voxelVolume();
  for (std::size_t i = 0; i < cells.tones.size(); ++i) {
    Tissue& tissue = tissues[basins.numbers[i]];
    tissue.volume += cellVolume;
    tissue.tones += cellVolume * cells.tones[i];
  }
  const CellNeighbours neighbours(cells.grid);
  neighbours.forPairs([&](std::size_t a, std::size_t b, int axis, glm::ivec3 index) {
    const std::uint32_t one = basins.numbers[a], other = basins.numbers[b];
    if (one == other) return;
    const std::size_t step = neighbours.step(axis);
    const std::size_t before = index[axis] > 0 ? a - step : a;
    const std::size_t behind = index[axis] + 2 < neighbours.dims()[axis] ? b + step : b;
    const float difference = std::max(std::abs(cells.tones[a] - cells.tones[b]),
                                      acrossShare * std::abs(cells.tones[before] - cells.tones[behind]));
    const auto area = static_cast<float>(neighbours.faceArea(axis));
    for (const auto& [from, to] : {std::pair{one, other}, std::pair{other, one}}) {
      TissueContact& contact = tissues[from].contacts[to];
      contact.area += area;
      contact.difference += area * difference;
      tissues[from].surface += area;
    }
  });
  return tissues;
}

float edgeBetween(const Tissue& a, const Tissue& b, const TissueContact& contact) {
  return static_cast<float>(std::abs(a.mean() - b.mean())) + contact.difference / contact.area;
}

std::optional<MergeTree> mergeTissues(std::vector<Tissue> tissues, const std::function<bool(double)>& goOn) {
  return Merger(std::move(tissues)).run(goOn);
}

}  // namespace fenestra::segmentation
