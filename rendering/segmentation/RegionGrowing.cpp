#include "rendering/segmentation/RegionGrowing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "rendering/segmentation/BoneTree.h"
#include "rendering/segmentation/BoneVoxels.h"
#include "rendering/segmentation/MemoryBuild.h"
#include "rendering/segmentation/Morphology.h"
#include "rendering/segmentation/Painting.h"
#include "rendering/segmentation/RegionCut.h"
#include "rendering/segmentation/Smoothing.h"
#include "rendering/segmentation/ValueGrower.h"

namespace fenestra::segmentation {
namespace {

// Chosen on the marked structures of tests/bench/results/growing.md.
constexpr double tissuesHandicap = 0.25;  ///< of the clarity: a region by tissues must be clearer by this much
// A further seed adds no more than these multiples of the region, beside it or apart from it, or than this multiple of
// a structure's usual size: what a click missed is seldom larger, a leak is. Apart from it, it means a structure of its
// own, which may be far larger.
constexpr double mostOfMissed = 0.5, mostOfOther = 10.0, mostAdded = 20.0;
/// Of the clarity: bones are as thin within as at their joints in places, so that a part of one may be clearer than
/// all.
constexpr double boneHandicap = 0.5;
constexpr double marrowShare = 0.9;    ///< of a region that lies in a bone
constexpr double leastContrast = 1.0;  ///< deviations of the noise, of a border
constexpr double loudNoise = 2.0;      ///< differences that the eye tells apart
constexpr double besideRadius = 4.0;   ///< voxel sides
/// mm, and voxel sides, whichever is less: a seed farther from the region means more than a piece of it.
constexpr double farthestGap = 30.0, farthestGapSides = 40.0;
/// Radius of the largest ball that a further seed adds, as a multiple of its distance from the region: one at the
/// surface means a layer.
constexpr double gapReach = 3.0;
/// CutCost::perVolume times the side of a cube as large as the body: smaller bodies have smaller structures. What is
/// soft has edges to go by, bones have their shape alone.
constexpr double boneCutPerVolume = 9.0, tissueCutPerVolume = 3.0;

/// A label map with a label for each step, whose voxels the caller sets.
std::shared_ptr<LabelMap> emptySteps(const Grid& grid) {
  auto steps = std::make_shared<LabelMap>();
  steps->grid = grid;
  steps->voxels = Voxels(ScalarType::UInt8, grid.voxelCount());
  for (int step = 1; step <= stepCount; ++step)
    steps->labels.push_back({static_cast<std::uint16_t>(step), {}, regionColour});
  return steps;
}

/// Grows a region in a box, as its settings say.
class SeedGrower {
 public:
  SeedGrower(const Volume& volume, const VoxelBox& box, const RegionFocus& settings, const Progress& progress)
      : volume_(volume), box_(box), progress_(progress) {
    if (settings.ball > 0.0) ball_ = {settings.inside.front(), settings.ball};
  }

  /// By values alone.
  std::optional<Growth> run(const RegionFocus& settings) {
    const auto region = grownByValues(seedsIn(settings.inside), seedsIn(settings.outside));
    if (!region) return std::nullopt;
    return growthOf(region->joins, region->curve, region->noise, 0.0);
  }

  /// From the first seed by values or by tissues of the whole volume, whichever is clearer; what the further seeds mean
  /// is added, and what the seeds outside mean is taken away.
  std::optional<Growth> run(const RegionFocus& settings, const GrowthMemory& memory) {
    const std::vector<glm::ivec3> inside = seedsIn(settings.inside), outside = seedsIn(settings.outside);
    const auto isWanted = [&](const FirstRegion& first) {
      return first.seed == inside.front() && first.ball == settings.ball && first.centre == settings.inside.front();
    };
    // Before another one is grown: both would take twice the memory.
    if (memory.first() && !isWanted(*memory.first())) memory.first() = nullptr;
    {
      MemoryBuild build(volume_, memory, inside);
      std::shared_ptr<FirstRegion> first;
      if (!memory.first() && !(first = grownByValues({inside.front()}, {}))) return std::nullopt;
      if (!build.wait([this] { return goOn(0.8); }) || !goOn(0.8)) return std::nullopt;
      if (first) {
        first->ball = settings.ball;
        first->centre = settings.inside.front();
        letOthersCompete(*first, *memory.tissues(), memory.bones().get());
        memory.first() = std::move(first);
      }
    }
    if (!goOn(0.9)) return std::nullopt;
    const FirstRegion& first = *memory.first();
    const double body = memory.tissues()->bodyVolume();
    if (inside.size() == 1 && outside.empty()) return growthOf(first.joins, first.curve, first.noise, body);
    return corrected(first, inside, outside, *memory.tissues(), memory.bones().get());
  }

 private:
  /// Empty when cancelled.
  std::shared_ptr<FirstRegion> grownByValues(const std::vector<glm::ivec3>& inside,
                                             const std::vector<glm::ivec3>& outside) const {
    ValueGrower byValues(volume_, box_);
    std::optional<std::vector<Level>> joins = byValues.joins(inside, outside, progress_);
    if (!joins) return nullptr;
    keepToBall(*joins);
    auto region = std::make_shared<FirstRegion>();
    region->seed = inside.front();
    region->joins = std::move(*joins);
    region->costs = byValues.takeCosts();
    region->noise = byValues.noise();
    region->curve = curveOf(region->joins, *region);
    return region;
  }

  /// Replaces a region by values with the one by tissues or the bone where that is clearer, one of marrow with its
  /// bone, and begins with the clearest step.
  void letOthersCompete(FirstRegion& region, const TissueTree& tissues, const BoneTree* bones) const {
    const StructurePrior prior = priorOf(region, tissues);
    auto clearest = clearestStep(region.curve, prior, volume_.grid);
    const auto compete = [&](std::vector<Level> joins, std::span<const Level> costs, const StructurePrior& own,
                             int last, auto wins) {
      keepToBall(joins);
      GrowthCurve curve = curveOf(joins, costs, region.noise);
      const auto other = clearestStep(curve, own, volume_.grid, last);
      if (!other || !wins(joins, *other)) return false;
      region.curve = std::move(curve);
      region.joins = std::move(joins);
      clearest = other;
      return true;
    };
    compete(tissues.joinsOf(volume_, region.seed), region.costs, prior, stepCount,
            [&](const std::vector<Level>&, const ClearestStep& other) {
              return !clearest || other.clarity > clearest->clarity + tissuesHandicap;
            });
    if (std::optional<std::vector<Level>> bone = bones ? bones->joinsOf(region.seed) : std::nullopt)
      region.isBone = compete(std::move(*bone), boneCosts(volume_, region.noise), ofBone(prior), BoneTree::lastStep(),
                              [&](const std::vector<Level>& joins, const ClearestStep& other) {
                                return bones->isBone(volume_, joins, other.step) &&
                                       (!clearest || other.clarity > clearest->clarity ||
                                        isMarrow(region.joins, clearest->step, joins, other.step));
                              });
    if (clearest) beginWith(region.curve, clearest->step);
  }

  /// Whether a region lies in a bone, and most of it is less dense than bone.
  bool isMarrow(const std::vector<Level>& joins, int step, const std::vector<Level>& bone, int boneStep) const {
    std::size_t all = 0, within = 0, soft = 0;
    for (std::size_t i = 0; i < joins.size(); ++i)
      if (joins[i] < step) {
        ++all;
        within += bone[i] < boneStep ? 1 : 0;
        soft += volume_.value(wholeOf(volume_.grid.dims).at(i)) < boneFrom ? 1 : 0;
      }
    return static_cast<double>(within) >= marrowShare * static_cast<double>(all) && 2 * soft > all;
  }

  /// The region of a first seed as the further ones change it.
  Growth corrected(const FirstRegion& first, const std::vector<glm::ivec3>& inside,
                   const std::vector<glm::ivec3>& outside, const TissueTree& tissues, const BoneTree* bones) const {
    std::vector<Level> joins = first.joins;
    const int automatic = first.curve.automatic;
    // The region at the chosen step, whatever the tolerance: it must not depend on when seeds were added.
    StructurePrior prior = priorOf(first, tissues);
    prior.expected = first.curve.volume[static_cast<std::size_t>(automatic)];
    for (const glm::ivec3& seed : std::span(inside).subspan(1))
      addAt(seed, tissues, bones, prior, first, automatic, joins);
    if (!outside.empty()) {
      const CutCost cost = cutCost(first, tissues.bodyVolume());
      const std::vector<std::uint8_t> taken = cutOff(volume_, joins, automatic, inside, outside, cost);
      // A greater tolerance stops before it would reach a seed outside, and adds nothing where one has cut.
      Level last = never;
      for (const glm::ivec3& seed : outside)
        last = std::min(last, std::max(static_cast<Level>(automatic), joins[wholeOf(volume_.grid.dims).offset(seed)]));
      for (std::size_t i = 0; i < joins.size(); ++i)
        if (taken[i] || joins[i] >= last) joins[i] = never;
    }
    // The tolerance stays: what is added and taken away is all that changes.
    GrowthCurve curve = curveOf(joins, first);
    beginWith(curve, automatic);
    return growthOf(joins, std::move(curve), first.noise, tissues.bodyVolume());
  }

  static CutCost cutCost(const FirstRegion& first, double bodyVolume) {
    const double side = std::cbrt(std::max(1.0, bodyVolume));
    if (first.isBone) return {.perVolume = boneCutPerVolume / side, .edge = std::numeric_limits<double>::infinity()};
    return {.perVolume = tissueCutPerVolume / side, .edge = first.noise.unit};
  }

  static StructurePrior ofBone(StructurePrior prior) {
    prior.smallerHandicap = boneHandicap;
    return prior;
  }

  StructurePrior priorOf(const FirstRegion& region, const TissueTree& tissues) const {
    StructurePrior prior = structurePrior(tissues.bodyVolume(), isGasAt(region.seed));
    // A border's contrast is a mean over many faces, so that it is seen below the noise of a single voxel.
    prior.contrast =
        leastContrast * std::min(region.noise.deviation, loudNoise * region.noise.seen) / region.noise.unit;
    return prior;
  }

  /// Nothing joins outside the ball around the first seed, where there is one.
  void keepToBall(std::vector<Level>& joins) const {
    if (!ball_) return;
    const glm::dvec3 centre = ball_->centre;
    const double square = ball_->radius * ball_->radius;
    forRows(box_.dims(), [&](int y, int z, std::size_t begin) {
      for (int x = 0; x < box_.dims().x; ++x) {
        const glm::dvec3 index(box_.low + glm::ivec3(x, y, z));
        const glm::dvec3 away = glm::dvec3(volume_.grid.worldFromIndex() * glm::dvec4(index, 1.0)) - centre;
        if (glm::dot(away, away) > square) joins[begin + static_cast<std::size_t>(x)] = never;
      }
    });
  }

  /// The clearest tissue or bone at a further seed joins at the step `automatic`, with its own larger and smaller ones
  /// around it.
  void addAt(const glm::ivec3& seed, const TissueTree& tissues, const BoneTree* bones, StructurePrior prior,
             const FirstRegion& first, int automatic, std::vector<Level>& joins) const {
    const std::optional<double> gap = gapTo(seed, joins, automatic);
    if (gap == 0.0) return;
    const bool isBeside = gap && *gap <= besideRadius * voxelSide(volume_.grid);
    prior.most = std::min(prior.most,
                          std::max((isBeside ? mostOfMissed : mostOfOther) * prior.expected, mostAdded * prior.usual));
    if (gap) prior.most = std::min(prior.most, 4.0 / 3.0 * std::numbers::pi * std::pow(gapReach * *gap, 3.0));
    prior.limit = prior.most;
    std::vector<Level> own = tissues.joinsOf(volume_, seed);
    keepToBall(own);
    std::optional<ClearestStep> clearest = clearestStep(curveOf(own, first), prior, volume_.grid);
    if (std::optional<std::vector<Level>> bone = bones ? bones->joinsOf(seed) : std::nullopt) {
      keepToBall(*bone);
      const GrowthCurve curve = curveOf(*bone, boneCosts(volume_, first.noise), first.noise);
      const auto other = clearestStep(curve, ofBone(prior), volume_.grid, BoneTree::lastStep());
      if (other && bones->isBone(volume_, *bone, other->step) &&
          (first.isBone || !clearest || other->clarity > clearest->clarity)) {
        own = std::move(*bone);
        clearest = other;
      }
    }
    const int shift = automatic - (clearest ? clearest->step : 1);
    for (std::size_t i = 0; i < joins.size(); ++i)
      if (own[i] != never)
        joins[i] = std::min(joins[i], static_cast<Level>(std::clamp(own[i] + shift, 0, levelCount - 1)));
  }

  /// mm from a voxel to the region of a step; empty where that is farther than a piece of the region would be.
  std::optional<double> gapTo(glm::ivec3 voxel, const std::vector<Level>& joins, int step) const {
    const VoxelBox whole = wholeOf(volume_.grid.dims);
    const double farthest = std::min(farthestGap, farthestGapSides * voxelSide(volume_.grid));
    std::optional<double> gap;
    for (const glm::ivec3 offset : ballOffsets(volume_.grid, farthest)) {
      if (!whole.contains(voxel + offset) || joins[whole.offset(voxel + offset)] >= step) continue;
      const double away = glm::length(glm::dvec3(volume_.grid.worldFromIndex() * glm::dvec4(glm::dvec3(offset), 0.0)));
      gap = std::min(gap.value_or(away), away);
    }
    return gap;
  }

  bool isGasAt(glm::ivec3 seed) const { return volume_.isInHounsfieldUnits() && volume_.value(seed) < gasBelow; }

  GrowthCurve curveOf(const std::vector<Level>& joins, const FirstRegion& first) const {
    return curveOf(joins, first.costs, first.noise);
  }
  GrowthCurve curveOf(const std::vector<Level>& joins, std::span<const Level> costs, const Noise& noise) const {
    return growthCurve(joins, costs, volume_.grid, box_.dims(), noise.share());
  }

  Growth growthOf(const std::vector<Level>& joins, GrowthCurve curve, const Noise& noise, double bodyVolume) const {
    Growth growth;
    growth.box = box_;
    growth.noise = noise.unit;
    growth.curve = std::move(curve);
    growth.bodyVolume = bodyVolume;
    growth.steps = stepsOf(joins);
    goOn(1.0);
    return growth;
  }

  bool goOn(double fraction) const { return !progress_ || progress_(fraction); }

  std::vector<glm::ivec3> seedsIn(const std::vector<glm::dvec3>& seeds) const {
    std::vector<glm::ivec3> voxels;
    for (const glm::dvec3 seed : seeds)
      if (const auto voxel = voxelAt(volume_.grid, seed); voxel && box_.contains(*voxel)) voxels.push_back(*voxel);
    return voxels;
  }

  std::shared_ptr<const LabelMap> stepsOf(const std::vector<Level>& joins) const {
    const std::shared_ptr<LabelMap> steps = emptySteps(volume_.grid);
    std::uint8_t* all = steps->voxels.as<std::uint8_t>().data();
    if (box_ != wholeOf(volume_.grid.dims))
      parallelFor(volume_.grid.voxelCount(), std::size_t{1} << 20,
                  [&](std::size_t begin, std::size_t end) { std::fill(all + begin, all + end, std::uint8_t{0}); });
    forRows(box_.dims(), [&](int y, int z, std::size_t begin) {
      std::uint8_t* to = all + volume_.grid.offset(box_.low + glm::ivec3(0, y, z));
      for (std::size_t x = 0; x < static_cast<std::size_t>(box_.dims().x); ++x)
        to[x] = static_cast<std::uint8_t>(joins[begin + x] + 1);  // never, 255, becomes 0
    });
    return steps;
  }

  const Volume& volume_;
  VoxelBox box_;
  const Progress& progress_;
  struct Ball {
    glm::dvec3 centre;  ///< world mm
    double radius;      ///< mm
  };
  std::optional<Ball> ball_;
};

/// The growth of a region that is only painted.
Growth nothingGrown(const Volume& volume) {
  Growth growth;
  growth.noise = noiseOf(volume).unit;
  const std::shared_ptr<LabelMap> steps = emptySteps(volume.grid);
  std::ranges::fill(steps->voxels.as<std::uint8_t>(), std::uint8_t{0});
  growth.steps = steps;
  const std::vector<double> none(static_cast<std::size_t>(stepCount) + 1, 0.0);
  growth.curve = {none, none, none, {}, 1};
  return growth;
}

void paintOver(Growth& growth, const Volume& volume, std::span<const SelectionStroke> strokes) {
  const std::shared_ptr<LabelMap> steps = emptySteps(volume.grid);
  std::ranges::copy(growth.steps->voxels.as<std::uint8_t>(), steps->voxels.as<std::uint8_t>().begin());
  const double each = volume.grid.voxelVolume();
  std::vector<double> counts;
  for (const double size : growth.curve.volume) counts.push_back(std::round(size / each));
  paint(steps->voxels.as<std::uint8_t>(), counts, volume, growth.noise, strokes);
  for (std::size_t step = 0; step < counts.size(); ++step) growth.curve.volume[step] = counts[step] * each;
  for (const SelectionStroke& stroke : strokes) {
    const VoxelBox box = boxOf(stroke, volume.grid);
    if (growth.box.empty()) growth.box = box;
    if (!box.empty()) growth.box = {glm::min(growth.box.low, box.low), glm::max(growth.box.high, box.high)};
  }
  growth.steps = steps;
}

}  // namespace

double Growth::toleranceOf(int step) const { return step > 0 ? costOf(step - 1) * noise : 0.0; }

int Growth::stepOf(double tolerance) const {
  const Level level = levelOf(std::max(0.0, tolerance) / noise);
  return std::min<int>(level, levelCount - 1) + 1;
}

int Growth::stepOf(const RegionFocus& settings) const {
  return settings.tolerance ? stepOf(*settings.tolerance) : curve.automatic;
}

bool canGrow(const Volume& volume, const RegionFocus& region) {
  return std::any_of(region.inside.begin(), region.inside.end(),
                     [&](glm::dvec3 seed) { return voxelAt(volume.grid, seed).has_value(); }) ||
         std::any_of(region.painted.begin(), region.painted.end(),
                     [&](const SelectionStroke& stroke) { return stroke.adds && !boxOf(stroke, volume.grid).empty(); });
}

bool haveSameSeeds(const RegionFocus& a, const RegionFocus& b) {
  return a.inside == b.inside && a.outside == b.outside && a.painted == b.painted && a.rule == b.rule &&
         a.ball == b.ball;
}

std::optional<Growth> paintedOn(const Growth& growth, const RegionFocus& grownFrom, const RegionFocus& wanted,
                                const Volume& volume) {
  const std::vector<SelectionStroke>&first = grownFrom.painted, &all = wanted.painted;
  RegionFocus begun = wanted;
  if (first.size() > all.size()) return std::nullopt;
  begun.painted.resize(first.size());
  if (!haveSameSeeds(grownFrom, begun)) return std::nullopt;
  Growth painted = growth;
  paintOver(painted, volume, std::span(all).subspan(first.size()));
  return painted;
}

std::optional<glm::ivec3> voxelAt(const Grid& grid, glm::dvec3 world) {
  const glm::dvec3 index(grid.indexFromWorld() * glm::dvec4(world, 1.0));
  // Compared before they are rounded: a far position has no int.
  if (!glm::all(glm::greaterThanEqual(index, glm::dvec3(-0.5))) ||
      !glm::all(glm::lessThan(index, glm::dvec3(grid.dims) - 0.5)))
    return std::nullopt;
  return glm::clamp(glm::ivec3(glm::floor(index + 0.5)), glm::ivec3(0), grid.dims - 1);
}

VoxelBox previewBox(const Volume& volume, const RegionFocus& settings) {
  constexpr int half = 56;  // voxels: 1.4 million in all
  const VoxelBox whole = wholeOf(volume.grid.dims);
  for (const glm::dvec3 seed : settings.inside)
    if (const auto voxel = voxelAt(volume.grid, seed))
      return VoxelBox{*voxel - half, *voxel + half + 1}.clippedTo(whole);
  return whole;
}

std::optional<Growth> growRegion(const Volume& volume, const RegionFocus& settings, const VoxelBox& reach,
                                 const Progress& progress, const GrowthMemory& memory) {
  const VoxelBox whole = wholeOf(volume.grid.dims), box = reach.clippedTo(whole);
  const bool grows = std::any_of(settings.inside.begin(), settings.inside.end(), [&](glm::dvec3 seed) {
    const auto voxel = voxelAt(volume.grid, seed);
    return voxel && box.contains(*voxel);
  });
  assert(grows || !settings.painted.empty());
  std::optional<Growth> growth;
  if (!grows) {
    growth = nothingGrown(volume);
  } else if (settings.rule == RegionRule::Tissues && box == whole) {
    growth = SeedGrower(volume, box, settings, progress).run(settings, memory);
  } else {
    growth = SeedGrower(volume, box, settings, progress).run(settings);
  }
  if (growth && !settings.painted.empty()) paintOver(*growth, volume, settings.painted);
  return growth;
}

}  // namespace fenestra::segmentation
