#include "rendering/segmentation/Corrections.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "rendering/segmentation/Morphology.h"
#include "rendering/segmentation/RegionBalls.h"
#include "rendering/segmentation/RegionCut.h"

namespace fenestra::segmentation {
namespace {

// Chosen on the marked structures of tests/bench/results/growing.md.
// A further seed adds no more than these multiples of the region, beside it or apart from it, or than this multiple of
// a structure's usual size: what a click missed is seldom larger, a leak is. Apart from it, it means a structure of its
// own, which may be far larger.
constexpr double mostOfMissed = 0.5, mostOfOther = 10.0, mostAdded = 20.0;
constexpr double besideRadius = 4.0;  ///< voxel sides
/// mm, and voxel sides, whichever is less: a seed farther from the region means more than a piece of it.
constexpr double farthestGap = 30.0, farthestGapSides = 40.0;
/// Radius of the largest ball that a further seed adds, as a multiple of its distance from the region: one at the
/// surface means a layer.
constexpr double gapReach = 3.0;
/// Voxel sides: a seed no farther from the region lies in its rim, and means no more than a rim of the same thickness.
constexpr double rimGap = 1.8;
constexpr double rimReach = 3.0;  ///< voxel sides from such a seed: the rim's values differ elsewhere
/// Voxel sides: what a seed farther from the region adds is bounded by its volume alone.
constexpr double boundedGap = 5.0;
constexpr double crumbShare = 0.1;  ///< of a structure's usual size: what a cut would leave is no structure
constexpr double leakShare = 0.01;  ///< of the body's volume: a larger region may have leaked
/// CutCost::perVolume times the side of a cube as large as the body: smaller bodies have smaller structures. What is
/// soft has edges to go by, bones have their shape alone.
constexpr double boneCutPerVolume = 9.0, tissueCutPerVolume = 3.0;

CutCost cutCost(const FirstRegion& first, const StructurePrior& prior, double bodyVolume) {
  const double side = std::cbrt(std::max(1.0, bodyVolume)), crumb = crumbShare * prior.usual;
  if (first.isBone)
    return {.perVolume = boneCutPerVolume / side, .edge = std::numeric_limits<double>::infinity(), .crumb = crumb};
  CutCost cost{.perVolume = tissueCutPerVolume / side, .edge = first.noise.unit, .crumb = crumb};
  // What is parted by shape already has not leaked far.
  if (!first.isTube) cost.leak = leakShare * bodyVolume;
  return cost;
}

/// mm from a voxel to the region of a step; empty where that is farther than a piece of the region would be.
std::optional<double> gapTo(const Grid& grid, glm::ivec3 voxel, const std::vector<Level>& joins, int step) {
  const VoxelBox whole = wholeOf(grid.dims);
  const double farthest = std::min(farthestGap, farthestGapSides * voxelSide(grid));
  std::optional<double> gap;
  for (const glm::ivec3 offset : ballOffsets(grid, farthest)) {
    if (!whole.contains(voxel + offset) || joins[whole.offset(voxel + offset)] >= step) continue;
    const double away = glm::length(glm::dvec3(grid.worldFromIndex() * glm::dvec4(glm::dvec3(offset), 0.0)));
    gap = std::min(gap.value_or(away), away);
  }
  return gap;
}

/// Voxels of a region that another one lacks at its step.
double addedBy(const Competition::Region& region, const std::vector<Level>& joins, int step) {
  double added = 0.0;
  for (std::size_t i = 0; i < joins.size(); ++i) added += region.joins[i] < region.step && joins[i] >= step ? 1.0 : 0.0;
  return added;
}

/// A seed in the rim of a region says that values as far from the region's as its own still belong: its neighbours join
/// that lie in the rim, too.
void addRim(glm::ivec3 seed, double gap, const Volume& volume, int step, std::vector<Level>& joins) {
  const VoxelBox whole = wholeOf(volume.grid.dims);
  const double side = voxelSide(volume.grid);
  const std::vector<glm::ivec3> near = ballOffsets(volume.grid, rimReach * side), rim = ballOffsets(volume.grid, gap);
  const auto holds = [&](glm::ivec3 at) { return whole.contains(at) && joins[whole.offset(at)] < step; };
  double sum = 0.0, count = 0.0;
  for (const glm::ivec3 offset : near)
    if (holds(seed + offset)) {
      sum += volume.value(seed + offset);
      ++count;
    }
  const double mean = sum / count, farthest = std::abs(volume.value(seed) - mean);
  std::vector<std::size_t> added{whole.offset(seed)};
  for (const glm::ivec3 offset : near) {
    const glm::ivec3 at = seed + offset;
    if (!whole.contains(at) || holds(at) || !(std::abs(volume.value(at) - mean) <= farthest)) continue;
    if (std::ranges::any_of(rim, [&](glm::ivec3 away) { return holds(at + away); })) added.push_back(whole.offset(at));
  }
  for (const std::size_t each : added) joins[each] = static_cast<Level>(step - 1);
}

/// What a seed beside a region means ends as far behind the seed as the region lies before it, by and large.
void keepNear(double gap, const Grid& grid, const std::vector<Level>& joins, int step, Competition::Region& own) {
  const VoxelBox whole = wholeOf(grid.dims);
  const std::vector<BallOffset> reach = nearestFirst(grid, 2.0 * gap);
  for (std::size_t i = 0; i < own.joins.size(); ++i) {
    if (own.joins[i] == never || joins[i] < step) continue;
    const glm::ivec3 at = whole.at(i);
    const bool isNear = own.joins[i] < own.step && std::ranges::any_of(reach, [&](const BallOffset& away) {
                          return whole.contains(at + away.step) && joins[whole.offset(at + away.step)] < step;
                        });
    if (!isNear) own.joins[i] = never;
  }
}

/// The clearest region at a further seed joins at the step `automatic`, with its own larger and smaller ones around it.
void addAt(glm::ivec3 seed, const Volume& volume, const Competition& competition, StructurePrior prior,
           const FirstRegion& first, std::vector<Level>& joins) {
  const int automatic = first.curve.automatic;
  const std::optional<double> gap = gapTo(volume.grid, seed, joins, automatic);
  if (gap == 0.0) return;
  const double side = voxelSide(volume.grid);
  if (gap && *gap <= rimGap * side) return addRim(seed, *gap, volume, automatic, joins);
  const bool isBeside = gap && *gap <= besideRadius * side;
  prior.most =
      std::min(prior.most, std::max((isBeside ? mostOfMissed : mostOfOther) * prior.expected, mostAdded * prior.usual));
  if (gap) prior.most = std::min(prior.most, 4.0 / 3.0 * std::numbers::pi * std::pow(gapReach * *gap, 3.0));
  prior.limit = prior.most;
  std::optional<Competition::Region> tube = competition.furtherTube(seed, first);
  // A tube near the one that was clicked goes on with it; a longer one is another.
  if (tube && addedBy(*tube, joins, automatic) * volume.grid.voxelVolume() >
                  (gap ? mostOfMissed : mostOfOther) * prior.expected)
    tube.reset();
  Competition::Region own = tube ? std::move(*tube) : competition.further(seed, prior, first);
  if (gap && *gap <= boundedGap * side) keepNear(*gap, volume.grid, joins, automatic, own);
  const int shift = automatic - own.step;
  for (std::size_t i = 0; i < joins.size(); ++i)
    if (own.joins[i] != never)
      joins[i] = std::min(joins[i], static_cast<Level>(std::clamp(own.joins[i] + shift, 0, levelCount - 1)));
}

/// The seeds outside that tell of a leak: they do not lie in the rim of the region.
struct DeepSeeds {
  std::vector<glm::ivec3> beyond;  ///< in a part that is far thicker: a narrow place lies between
  std::vector<glm::ivec3> beside;  ///< in its middle, in one no thicker: no shape parts them from the first seed
};
DeepSeeds deepSeeds(const Grid& grid, const FirstRegion& region, std::span<const glm::ivec3> outside) {
  DeepSeeds seeds;
  const RegionBalls shape(grid, region.joins, region.curve.automatic);
  if (!shape.holds(region.seed)) {
    // A click on a border may lie beside its region, which is that of its neighbourhood. It has no depth there to
    // compare others with, so that no shape is known to part them.
    std::ranges::copy_if(outside, std::back_inserter(seeds.beside), [&](glm::ivec3 seed) { return shape.holds(seed); });
    return seeds;
  }
  const double own = shape.depthOf(shape.ballAt(region.seed));
  for (const glm::ivec3 seed : outside) {
    if (!shape.holds(seed)) continue;
    const double depth = shape.ballAt(seed).depth;
    if (depth > leakThickness * own)
      seeds.beyond.push_back(seed);
    else if (depth > 0.5 * own)  // nearer to the middle than to the surface
      seeds.beside.push_back(seed);
  }
  return seeds;
}

/// Takes away what lies beyond the narrow places, up to every tolerance.
void cutLeak(const Volume& volume, const Competition& competition, std::span<const glm::ivec3> beyond,
             FirstRegion& region) {
  const int automatic = region.curve.automatic;
  const CutCost cost = cutCost(region, competition.priorOf(region), competition.bodyVolume());
  const std::vector<std::uint8_t> taken =
      cutOff(volume, region.joins, automatic, std::span(&region.seed, 1), beyond, cost);
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (taken[i] || region.joins[i] >= automatic) region.joins[i] = never;
  region.curve = competition.curveOf(region.joins, region);
  beginWith(region.curve, automatic);
}

/// The region of the first seed that a leak hides; empty where no seed outside tells of one. It is found without the
/// further seeds inside, which add to what a user has seen when they were set.
std::optional<FirstRegion> behindLeak(const Volume& volume, const Competition& competition, const FirstRegion& first,
                                      std::span<const glm::ivec3> outside) {
  if (first.isBone || first.isTube ||
      first.curve.volume[static_cast<std::size_t>(first.curve.automatic)] <= leakShare * competition.bodyVolume())
    return std::nullopt;
  std::optional<FirstRegion> found;
  std::vector<glm::ivec3> excluded, others(outside.begin(), outside.end());
  while (!found || !(found->isBone || found->isTube)) {
    const DeepSeeds seeds = deepSeeds(volume.grid, found ? *found : first, others);
    for (const auto* deep : {&seeds.beside, &seeds.beyond})
      for (const glm::ivec3 seed : *deep) {
        excluded.push_back(seed);
        std::erase(others, seed);
      }
    if (!seeds.beside.empty()) {
      std::optional<FirstRegion> without = competition.without(excluded, first);
      if (!without) break;
      found = std::move(without);
    } else if (!seeds.beyond.empty()) {
      if (!found) found = first;
      cutLeak(volume, competition, seeds.beyond, *found);
    } else {
      break;
    }
  }
  return found;
}

CorrectedRegion correctedBeyond(const Volume& volume, const Competition& competition, const FirstRegion& first,
                                std::span<const glm::ivec3> inside, std::span<const glm::ivec3> outside) {
  CorrectedRegion region{first.joins, {}};
  std::vector<Level>& joins = region.joins;
  const int automatic = first.curve.automatic;
  // The region at the chosen step, whatever the tolerance: it must not depend on when seeds were added.
  StructurePrior prior = competition.priorOf(first);
  prior.expected = first.curve.volume[static_cast<std::size_t>(automatic)];
  for (const glm::ivec3& seed : inside.subspan(1)) addAt(seed, volume, competition, prior, first, joins);
  if (!outside.empty()) {
    const std::vector<std::uint8_t> taken =
        cutOff(volume, joins, automatic, inside, outside, cutCost(first, prior, competition.bodyVolume()));
    // A greater tolerance stops before it would reach a seed outside, and adds nothing where one has cut.
    Level last = never;
    for (const glm::ivec3& seed : outside)
      last = std::min(last, std::max(static_cast<Level>(automatic), joins[wholeOf(volume.grid.dims).offset(seed)]));
    for (std::size_t i = 0; i < joins.size(); ++i)
      if (taken[i] || joins[i] >= last) joins[i] = never;
  }
  // The tolerance stays: what is added and taken away is all that changes.
  region.curve = competition.curveOf(joins, first);
  beginWith(region.curve, automatic);
  return region;
}

}  // namespace

CorrectedRegion corrected(const Volume& volume, const Competition& competition, const FirstRegion& first,
                          std::span<const glm::ivec3> inside, std::span<const glm::ivec3> outside) {
  if (std::optional<Competition::Region> walk = competition.furtherWalk(inside, outside, first)) {
    CorrectedRegion region{std::move(walk->joins), {}};
    region.curve = competition.curveOf(region.joins, first);
    beginWith(region.curve, walk->step);
    return region;
  }
  const std::optional<FirstRegion> found = behindLeak(volume, competition, first, outside);
  return correctedBeyond(volume, competition, found ? *found : first, inside, outside);
}

}  // namespace fenestra::segmentation
