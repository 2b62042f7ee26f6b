#include "rendering/segmentation/TissueMerger.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "rendering/segmentation/PairQueue.h"
#include "rendering/segmentation/TissuePairs.h"

namespace fenestra::segmentation {
namespace {

// Chosen on structures marked in tests/bench/results/growing.md, by the best Dice of any tolerance. A quarter of
// smallVolume changes it by 0.03 at most, four times as much costs a hip 0.14. A power of 0.5 costs an aorta 0.07, one
// of 0.25 a vertebra 0.27; organs hardly change.
constexpr double smallVolume = 2000.0;  ///< mm³: what is smaller merges at a lower cost
constexpr double sharePower = 0.35;
/// Weight of a difference over three faces, as a blurred edge has it, beside one over a single face.
constexpr float acrossShare = 0.7f;

/// How far two tissues differ at their border and as a whole, units of the noise.
float edgeBetween(const Tissue& a, const Tissue& b, const TissueContact& contact) {
  return static_cast<float>(std::abs(a.mean() - b.mean())) + contact.difference / contact.area;
}

float costOfMerging(const Tissue& a, const Tissue& b, const TissueContact& contact) {
  const double size = std::min(1.0, std::sqrt(std::min(a.volume, b.volume) / smallVolume));
  const double share = std::min(1.0, contact.area / std::min(a.surface, b.surface));
  return static_cast<float>(edgeBetween(a, b, contact) * size / std::pow(share, sharePower));
}

/// The contacts of each tissue are a list: two tissues that merge have theirs joined without a copy. A contact that has
/// become part of another one stays in its lists until they are walked.
class Merger {
 public:
  explicit Merger(Tissues tissues)
      : tissues_(std::move(tissues.all)),
        contacts_(std::move(tissues.contacts)),
        pairs_(contacts_.size()),
        links_(2 * contacts_.size()),
        lists_(tissues_.size()),
        nodes_(tissues_.size()),
        tree_{std::vector(tissues_.size(), UINT32_MAX), std::vector(tissues_.size(), 0.0f)} {
    std::iota(nodes_.begin(), nodes_.end(), std::uint32_t{0});
    owners_ = nodes_;
    for (std::uint32_t i = 0; i < contacts_.size(); ++i) {
      const TissueContact& contact = contacts_[i];
      pairs_(contact.a, contact.b) = i;
      append(2 * i, contact.a);
      append(2 * i + 1, contact.b);
      waiting_.push(pairOf(contact));
    }
  }

  std::optional<MergeTree> run(const std::function<bool(double)>& goOn) {
    const std::size_t leaves = tissues_.size();
    while (const std::optional<MergePair> pair = waiting_.pop()) {
      const std::uint32_t a = ownerOf(pair->a), b = ownerOf(pair->b);
      if (a == b) continue;
      const std::uint32_t contact = pairs_(a, b);
      const MergePair now = pairOf(contacts_[contact]);
      if (now.cost > pair->cost) {
        waiting_.push(now);
        continue;
      }
      merge(a, b, contact, now.cost);
      const std::size_t merged = tree_.parents.size() - leaves;
      if (merged % 4096 == 0 && goOn && !goOn(static_cast<double>(merged) / static_cast<double>(leaves)))
        return std::nullopt;
    }
    return std::move(tree_);
  }

 private:
  /// A tissue's contacts. Links 2 i and 2 i + 1 belong to contact i, one to each of its two tissues.
  struct List {
    std::uint32_t first = none, last = none;
    std::uint32_t count = 0;  ///< contacts; those that are part of another one do not count
  };
  static constexpr std::uint32_t none = UINT32_MAX;

  MergePair pairOf(const TissueContact& contact) const {
    return {costOfMerging(tissues_[contact.a], tissues_[contact.b], contact), std::min(contact.a, contact.b),
            std::max(contact.a, contact.b)};
  }

  void append(std::uint32_t link, std::uint32_t tissue) {
    List& list = lists_[tissue];
    (list.first == none ? list.first : links_[list.last]) = link;
    links_[link] = none;
    list.last = link;
    ++list.count;
  }

  /// The tissue that a merged one belongs to now.
  std::uint32_t ownerOf(std::uint32_t tissue) {
    while (owners_[tissue] != tissue) tissue = owners_[tissue] = owners_[owners_[tissue]];
    return tissue;
  }

  /// The one with fewer contacts goes into the other one.
  void merge(std::uint32_t a, std::uint32_t b, std::uint32_t between, float cost) {
    if (lists_[a].count < lists_[b].count) std::swap(a, b);
    const auto parent = static_cast<std::uint32_t>(tree_.parents.size());
    tree_.heights.push_back(std::max({cost, tree_.heights[nodes_[a]], tree_.heights[nodes_[b]]}));
    tree_.parents.push_back(UINT32_MAX);
    tree_.parents[nodes_[a]] = tree_.parents[nodes_[b]] = parent;
    nodes_[a] = parent;
    owners_[b] = a;
    Tissue &kept = tissues_[a], &gone = tissues_[b];
    kept.surface += gone.surface - 2.0 * contacts_[between].area;
    kept.volume += gone.volume;
    kept.tones += gone.tones;
    --lists_[a].count;
    contacts_[between].area = 0.0f;
    for (std::uint32_t link = lists_[b].first; link != none;) {
      const std::uint32_t next = links_[link];
      if (contacts_[link / 2].area > 0.0f) waiting_.push(pairOf(contacts_[moved(link, b, a)]));
      link = next;
    }
  }

  /// Lets a contact of `from` be one of `to`: itself, or the one that there is already.
  std::uint32_t moved(std::uint32_t link, std::uint32_t from, std::uint32_t to) {
    const std::uint32_t i = link / 2;
    TissueContact& contact = contacts_[i];
    const std::uint32_t other = contact.a == from ? contact.b : contact.a;
    std::uint32_t& both = pairs_(to, other);
    if (both == none) {
      both = i;
      (contact.a == from ? contact.a : contact.b) = to;
      append(link, to);
      return i;
    }
    contacts_[both].area += contact.area;
    contacts_[both].difference += contact.difference;
    contact.area = 0.0f;
    --lists_[other].count;
    return both;
  }

  std::vector<Tissue> tissues_;
  std::vector<TissueContact> contacts_;  ///< of area 0: part of another one, or within a tissue
  TissuePairs pairs_;
  std::vector<std::uint32_t> links_;           ///< the next one of a list
  std::vector<List> lists_;                    ///< by tissue
  std::vector<std::uint32_t> nodes_, owners_;  ///< by tissue
  MergeTree tree_;
  PairQueue waiting_;
};

}  // namespace

Tissues tissuesOf(const TissueCells& cells, const Basins& basins) {
  Tissues tissues{std::vector<Tissue>(basins.count), {}};
  const double cellVolume = cells.grid.voxelVolume();
  for (std::size_t i = 0; i < cells.tones.size(); ++i) {
    Tissue& tissue = tissues.all[basins.numbers[i]];
    tissue.volume += cellVolume;
    tissue.tones += cellVolume * cells.tones[i];
  }
  const CellNeighbours neighbours(cells.grid);
  TissuePairs pairs(8 * basins.count);
  neighbours.forPairs([&](std::size_t a, std::size_t b, int axis, glm::ivec3 index) {
    const std::uint32_t one = basins.numbers[a], other = basins.numbers[b];
    if (one == other) return;
    const std::size_t step = neighbours.step(axis);
    const std::size_t before = index[axis] > 0 ? a - step : a;
    const std::size_t behind = index[axis] + 2 < neighbours.dims()[axis] ? b + step : b;
    const float difference = std::max(std::abs(cells.tones[a] - cells.tones[b]),
                                      acrossShare * std::abs(cells.tones[before] - cells.tones[behind]));
    const auto area = static_cast<float>(neighbours.faceArea(axis));
    std::uint32_t& number = pairs(one, other);
    if (number == TissuePairs::none) {
      number = static_cast<std::uint32_t>(tissues.contacts.size());
      tissues.contacts.push_back({std::min(one, other), std::max(one, other)});
    }
    TissueContact& contact = tissues.contacts[number];
    contact.area += area;
    contact.difference += area * difference;
    for (const std::uint32_t each : {one, other}) tissues.all[each].surface += area;
  });
  return tissues;
}

std::optional<MergeTree> mergeTissues(Tissues tissues, const std::function<bool(double)>& goOn) {
  return Merger(std::move(tissues)).run(goOn);
}

}  // namespace fenestra::segmentation
