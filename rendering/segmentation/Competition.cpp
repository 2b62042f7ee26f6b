#include "rendering/segmentation/Competition.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rendering/segmentation/BoneRim.h"
#include "rendering/segmentation/BoneTree.h"
#include "rendering/segmentation/BoneVoxels.h"
#include "rendering/segmentation/RandomWalk.h"
#include "rendering/segmentation/RegionShape.h"
#include "rendering/segmentation/TissueCells.h"
#include "rendering/segmentation/TissueTree.h"
#include "rendering/segmentation/TubeTracer.h"
#include "rendering/segmentation/ValueGrower.h"

namespace fenestra::segmentation {
namespace {

// Chosen on the marked structures of tests/bench/results/growing.md.
constexpr double tissuesHandicap = 0.25;  ///< of the clarity: a region by tissues must be clearer by this much
/// A part of a bone must be clearer than the largest one that crosses no joint by this much: a part is more compact, so
/// that it is often clearer, and joints tell more than borders where a bone ends.
constexpr double boneHandicap = 1.0;
constexpr double marrowShare = 0.9;    ///< of a region that lies in a bone
constexpr double leastOfBorder = 1.0;  ///< deviations of the noise, of a border
constexpr double loudNoise = 2.0;      ///< differences that the eye tells apart

// A tube must be clearer than a region that is not bound to a shape by the first of these; by the second the more the
// shorter it is, and by the third the more the less of its wall is seen. An organ holds short tubes whose walls are
// partly its own.
constexpr double tubeHandicap = 0.4, shortHandicap = 2.0, unseenHandicap = 4.0;
constexpr double longTube = 7.0;   ///< diameters
constexpr double seenWall = 0.85;  ///< Tube::support

// A walk's region must be clearer than the other region by walkHandicap, and by clearHandicap for each unit of the
// other's clarity: what is hardly clear gives way sooner. Its clarity falls by unseenWalkHandicap for the part of its
// surface across which no difference is seen, because a piece of an organ has a border on some sides alone. Where the
// other region is much of the body, which is more often a leak, the lead that is wanted shrinks by muchHandicap.
constexpr double walkHandicap = 0.55, clearHandicap = 0.5, unseenWalkHandicap = 4.0, muchHandicap = 0.4;
constexpr double leastWalkClarity = -0.6;    ///< with less it is no region
constexpr double greatestWalkClarity = 0.8;  ///< of nearly all walks: beside what is clearer, none is tried
constexpr double seenSurface = 0.85;         ///< WalkRegion::support
// Weights of sharpness and compactness, as in Curve.cpp.
constexpr double walkSharpness = 0.7, walkCompactness = 0.9;

double clarityOf(const WalkRegion& walk) {
  return walkSharpness * std::log(walk.contrast) + walkCompactness * std::log(std::min(1.0, walk.compactness)) -
         unseenWalkHandicap * std::max(0.0, seenSurface - walk.support);
}

double handicapOf(const Tube& tube) {
  return tubeHandicap + shortHandicap * std::max(0.0, std::log(longTube / tube.diameters())) +
         unseenHandicap * std::max(0.0, seenWall - tube.support);
}

StructurePrior ofBone(StructurePrior prior) {
  prior.smallerHandicap = boneHandicap;
  return prior;
}

/// Whether a region lies in a bone; where `countsDensity`, also whether most of its voxels are less dense than bone, as
/// those of marrow are.
bool isWithin(const Volume& volume, const std::vector<Level>& joins, int step, const std::vector<Level>& bone,
              int boneStep, bool countsDensity) {
  const VoxelBox whole = wholeOf(volume.grid.dims);
  std::size_t all = 0, within = 0, soft = 0;
  for (std::size_t i = 0; i < joins.size(); ++i)
    if (joins[i] < step) {
      ++all;
      within += bone[i] < boneStep ? 1 : 0;
      soft += volume.value(whole.at(i)) < boneFrom ? 1 : 0;
    }
  return static_cast<double>(within) >= marrowShare * static_cast<double>(all) && (!countsDensity || 2 * soft > all);
}

/// The last step at which none of some seeds belongs to a region.
int lastWithout(std::span<const glm::ivec3> seeds, const std::vector<Level>& joins, const VoxelBox& whole) {
  int last = stepCount;
  for (const glm::ivec3 seed : seeds) last = std::min<int>(last, joins[whole.offset(seed)]);
  return last;
}

/// mm³ at the step with which a region begins.
double sizeOf(const FirstRegion& region) {
  return region.curve.volume[static_cast<std::size_t>(region.curve.automatic)];
}

}  // namespace

void keepTo(const std::optional<RegionBall>& ball, const Grid& grid, const VoxelBox& box, std::vector<Level>& joins) {
  if (!ball) return;
  const double square = ball->radius * ball->radius;
  forRows(box.dims(), [&](int y, int z, std::size_t begin) {
    for (int x = 0; x < box.dims().x; ++x) {
      const glm::dvec3 index(box.low + glm::ivec3(x, y, z));
      const glm::dvec3 away = glm::dvec3(grid.worldFromIndex() * glm::dvec4(index, 1.0)) - ball->centre;
      if (glm::dot(away, away) > square) joins[begin + static_cast<std::size_t>(x)] = never;
    }
  });
}

StructurePrior Competition::priorOf(const FirstRegion& region) const {
  const bool isGas = volume_.isInHounsfieldUnits() && volume_.value(region.seed) < gasBelow;
  StructurePrior prior = structurePrior(tissues_.bodyVolume(), isGas);
  // A border's contrast is a mean over many faces, so that it is seen below the noise of a single voxel.
  prior.contrast = leastOfBorder * std::min(region.noise.deviation, loudNoise * region.noise.seen) / region.noise.unit;
  return prior;
}

GrowthCurve Competition::curveOf(const std::vector<Level>& joins, std::span<const Level> costs,
                                 const Noise& noise) const {
  return growthCurve(joins, costs, volume_.grid, volume_.grid.dims, competingEdges(volume_, noise));
}

Noise Competition::boneNoise(const Noise& noise) const {
  return volume_.isInHounsfieldUnits() ? noise : noiseOf(bones_->inUnits(volume_));
}

GrowthCurve Competition::curveOf(const std::vector<Level>& joins, const FirstRegion& first) const {
  if (!first.isBone) return curveOf(joins, first.costs, first.noise);
  std::vector<Level> costs = boneCosts(bones_->inUnits(volume_), boneNoise(first.noise));
  for (const RimVoxel& each : first.rim) costs[each.offset] = each.cost;
  return curveOf(joins, costs, first.noise);
}

bool Competition::decide(FirstRegion& region, std::span<const glm::ivec3> outside) const {
  StructurePrior prior = priorOf(region);
  region.rim.clear();
  if (!outside.empty()) prior.limit = std::min(prior.limit, sizeOf(region));
  auto clearest =
      clearestStep(region.curve, prior, volume_.grid, lastWithout(outside, region.joins, wholeOf(volume_.grid.dims)));
  std::vector<GrowthCurve> curves{region.curve};  // by values, by tissues and, where there are bones, by bones
  const auto compete = [&](std::vector<Level> joins, std::span<const Level> costs, const StructurePrior& own, int last,
                           auto wins) {
    keepTo(ball_, volume_.grid, wholeOf(volume_.grid.dims), joins);
    GrowthCurve curve = curveOf(joins, costs, region.noise);
    curves.push_back(curve);
    const auto other =
        clearestStep(curve, own, volume_.grid, std::min(last, lastWithout(outside, joins, wholeOf(volume_.grid.dims))));
    if (!other || !wins(joins, *other)) return false;
    region.curve = std::move(curve);
    region.joins = std::move(joins);
    clearest = other;
    return true;
  };
  compete(tissues_.joinsOf(volume_, region.seed), region.costs, prior, stepCount,
          [&](const std::vector<Level>&, const ClearestStep& other) {
            return !clearest || other.clarity > clearest->clarity + tissuesHandicap;
          });
  // Costs are found in Hounsfield units, where differences above the display window count less. In units of the file,
  // each dense grain of a bone's cortex would have a border as clear as that of the bone, and win as a region.
  if (std::optional<std::vector<Level>> bone = bones_ ? bones_->joinsOf(region.seed) : std::nullopt)
    region.isBone =
        compete(std::move(*bone), boneCosts(bones_->inUnits(volume_), boneNoise(region.noise)), ofBone(prior),
                BoneTree::lastStep(), [&](const std::vector<Level>& joins, const ClearestStep& other) {
                  return bones_->isBone(volume_, joins, other.step) &&
                         (!clearest || other.clarity > clearest->clarity ||
                          isWithin(bones_->inUnits(volume_), region.joins, clearest->step, joins, other.step,
                                   volume_.isInHounsfieldUnits()));
                });
  const std::optional<TubeRegion> tube = clearerTube(region.seed, region, prior, clearest);
  if (tube && std::ranges::none_of(outside, [&](glm::ivec3 seed) { return holds(*tube, seed); })) {
    region.joins = allOf(tube->box, tube->joins);
    region.curve = curveOf(region.joins, region.costs, region.noise);
    if (volume_.isInHounsfieldUnits()) region.curve.flatness = tube->aspect;  // measured in CT alone
    region.isBone = false;
    region.isTube = true;
    clearest = ClearestStep{tubeLevel + 1};
  }
  const std::optional<WalkRegion> walk = outside.empty() ? clearerWalk(region, prior, clearest) : std::nullopt;
  if (walk) {
    region.joins = allOf(walk->box, walk->joins);
    region.curve = curveOf(region.joins, region.costs, region.noise);
    region.isWalk = true;
    clearest = ClearestStep{walk->step};
  }
  if (region.isBone) endAtRim(region, clearest->step, prior);
  if (clearest) beginWith(region.curve, clearest->step);
  if (clearest && !region.isBone && !region.isTube && !region.isWalk)
    compareWith(std::span(curves).first(2), prior, region);  // a bone is no rival of soft tissue
  return clearest.has_value();
}

void Competition::compareWith(std::span<const GrowthCurve> others, const StructurePrior& prior,
                              FirstRegion& region) const {
  // Measured in CT alone. Lungs have lobes as thick as one another, and nothing else is like them.
  if (!volume_.isInHounsfieldUnits() || volume_.value(region.seed) < gasBelow) return;
  GrowthCurve& curve = region.curve;
  const double volume = sizeOf(region);
  double beside = -std::numeric_limits<double>::infinity();
  for (const GrowthCurve& other : others) beside = std::max(beside, clarityBeside(other, volume, prior, volume_.grid));
  curve.lead = clarityAt(curve, curve.automatic, prior, volume_.grid) - beside;
  const RegionShape shape = shapeOf(volume_.grid, region.joins, curve.automatic, volume, region.seed);
  curve.sprawl = shape.thickening / shape.compactness;
}

std::optional<FirstRegion> Competition::without(std::span<const glm::ivec3> outside, const FirstRegion& first) const {
  FirstRegion region = first;
  if (decide(region, outside)) return region;
  region.joins = tissues_.joinsOf(volume_, region.seed);
  keepTo(ball_, volume_.grid, wholeOf(volume_.grid.dims), region.joins);
  region.curve = curveOf(region.joins, region.costs, region.noise);
  int last = lastWithout(outside, region.joins, wholeOf(volume_.grid.dims));
  while (last > 0 && region.curve.volume[static_cast<std::size_t>(last)] > sizeOf(first)) --last;
  if (region.curve.volume[static_cast<std::size_t>(last)] <= 0.0) return std::nullopt;
  beginWith(region.curve, last);
  return region;
}

std::optional<TubeRegion> Competition::clearerTube(glm::ivec3 seed, const FirstRegion& first,
                                                   const StructurePrior& prior,
                                                   const std::optional<ClearestStep>& other) const {
  const std::optional<Tube> tube = traceTube(volume_, first.noise, seed);
  if (!tube) return std::nullopt;
  TubeRegion region = tubeRegion(volume_, *tube);
  if (!holds(region, seed)) return std::nullopt;
  const VoxelBox whole = wholeOf(volume_.grid.dims);
  std::vector<Level> joins(region.joins.size()), costs(region.joins.size());
  for (std::size_t i = 0; i < joins.size(); ++i) {
    joins[i] = region.joins[i] <= tubeLevel ? tubeLevel : never;
    costs[i] = first.costs[whole.offset(region.box.at(i))];
  }
  const GrowthCurve curve =
      growthCurve(joins, costs, volume_.grid, region.box.dims(), competingEdges(volume_, first.noise));
  const auto own = clearestStep(curve, prior, volume_.grid);
  if (!own || (other && own->clarity <= other->clarity + handicapOf(*tube))) return std::nullopt;
  return region;
}

void Competition::endAtRim(FirstRegion& region, int step, const StructurePrior& prior) const {
  const double clarity = clarityAt(region.curve, step, prior, volume_.grid);
  const double volume = region.curve.volume[static_cast<std::size_t>(step)];
  const double beyond = clarityBeyond(region.curve, volume, prior, volume_.grid);
  region.rim = dropRim(region.joins, step, region.noise);
  region.curve = curveOf(region.joins, region);
  if (volume_.isInHounsfieldUnits()) region.curve.boneLead = clarity - beyond;  // measured there alone
}

std::vector<RimVoxel> Competition::dropRim(std::vector<Level>& joins, int step, const Noise& noise) const {
  std::vector<RimVoxel> rim = softRim(bones_->inUnits(volume_), boneNoise(noise), joins, step);
  for (const RimVoxel& each : rim) joins[each.offset] = never;
  return rim;
}

std::optional<WalkRegion> Competition::clearerWalk(const FirstRegion& region, const StructurePrior& prior,
                                                   const std::optional<ClearestStep>& other) const {
  // A bone and a tube are parted by their shape already, and a region in a ball by the user. Soft tissues of CT either
  // have a border that merging finds or none at all, and a walk takes a piece of an organ for it: of the structures of
  // CT measured none gained, and seeds of liver and pancreas lost theirs.
  if (region.isBone || region.isTube || ball_ || volume_.isInHounsfieldUnits()) return std::nullopt;
  double least = leastWalkClarity;
  if (other) {
    const double volume = region.curve.volume[static_cast<std::size_t>(other->step)];
    const double share = std::max(0.0, std::log(volume / prior.much));
    least = std::max(least, (1.0 + clearHandicap) * (other->clarity + costOfMuch(volume, prior)) + walkHandicap -
                                muchHandicap * share);
  }
  if (least >= greatestWalkClarity) return std::nullopt;
  std::optional<WalkRegion> walk = walkRegion(volume_, region.noise, std::span(&region.seed, 1), {});
  if (!walk || clarityOf(*walk) <= least) return std::nullopt;
  return walk;
}

std::optional<Competition::Region> Competition::furtherWalk(std::span<const glm::ivec3> inside,
                                                            std::span<const glm::ivec3> outside,
                                                            const FirstRegion& first) const {
  if (!first.isWalk) return std::nullopt;
  WalkBounds bounds;
  // Seeds of one kind only add, or only take away.
  if (outside.empty()) bounds.least = sizeOf(first);
  if (inside.size() == 1) bounds.most = sizeOf(first);
  const std::optional<WalkRegion> walk = walkRegion(volume_, first.noise, inside, outside, bounds);
  if (!walk || std::ranges::any_of(inside, [&](glm::ivec3 seed) {
        return !walk->box.contains(seed) || walk->joins[walk->box.offset(seed)] == never;
      }))
    return std::nullopt;
  return Region{allOf(walk->box, walk->joins), walk->step};
}

std::optional<Competition::Region> Competition::furtherTube(glm::ivec3 seed, const FirstRegion& first) const {
  if (!first.isTube) return std::nullopt;
  const std::optional<TubeRegion> tube = clearerTube(seed, first, priorOf(first), {});
  if (!tube) return std::nullopt;
  return Region{allOf(tube->box, tube->joins), tubeLevel + 1};
}

std::vector<Level> Competition::allOf(const VoxelBox& box, std::span<const Level> levels) const {
  std::vector<Level> joins(volume_.grid.voxelCount(), never);
  const VoxelBox whole = wholeOf(volume_.grid.dims);
  for (std::size_t i = 0; i < levels.size(); ++i) joins[whole.offset(box.at(i))] = levels[i];
  keepTo(ball_, volume_.grid, whole, joins);
  return joins;
}

Competition::Region Competition::further(glm::ivec3 seed, const StructurePrior& prior, const FirstRegion& first) const {
  const VoxelBox whole = wholeOf(volume_.grid.dims);
  Region region{tissues_.joinsOf(volume_, seed, TissueTree::From::Voxel)};
  keepTo(ball_, volume_.grid, whole, region.joins);
  auto clearest = clearestStep(curveOf(region.joins, first.costs, first.noise), prior, volume_.grid);
  bool isBone = false;
  if (std::optional<std::vector<Level>> bone = bones_ ? bones_->joinsOf(seed) : std::nullopt) {
    keepTo(ball_, volume_.grid, whole, *bone);
    const GrowthCurve curve = curveOf(*bone, boneCosts(bones_->inUnits(volume_), boneNoise(first.noise)), first.noise);
    const auto other = clearestStep(curve, ofBone(prior), volume_.grid, BoneTree::lastStep());
    if (other && bones_->isBone(volume_, *bone, other->step) &&
        (first.isBone || !clearest || other->clarity > clearest->clarity)) {
      region.joins = std::move(*bone);
      clearest = other;
      isBone = true;
    }
  }
  if (clearest) region.step = clearest->step;
  if (isBone) dropRim(region.joins, region.step, first.noise);
  return region;
}

}  // namespace fenestra::segmentation
