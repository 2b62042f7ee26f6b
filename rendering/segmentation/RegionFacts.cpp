#include "rendering/segmentation/RegionFacts.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

/// HU: darker lung is counted as air, too (Gevenois et al., American Journal of Respiratory and Critical Care Medicine
/// 152(2), 1995).
constexpr double airThreshold = -950.0;
/// Where values are no Hounsfield units, the lowest share of their range that counts as air.
constexpr double airShare = 0.02;

// Chosen on the marked structures of tests/bench/results/growing.md, so that no more than 5 % of the regions that do
// not leak are doubtful.
constexpr double strongEdge = 2.0, weakEdge = 0.75;  ///< noise units, averaged over the border
/// Share of the greatest rise that counts: in loud noise, that is a strong edge.
constexpr double strongShare = 0.5;
/// A region that is less compact is ragged, as leaks are; with a strong enough edge it may still be a long bone.
constexpr double leastCompact = 0.25, raggedEdge = 3.0;
constexpr double leakGrowth = 1.5;  ///< a region that grows by this factor in one step of its curve leaks there
/// Share of the radius of a ball of the volume of what joins. Where the middle of what joins lies nearer than this to
/// the region's middle, the leak has no direction to be named.
constexpr double leastOffset = 0.35;

/// Steps around a region's own, itself not counted: one that fewer steps hold is passed by, and no structure. What is
/// more of the body than most structures has had more borders to cross, and must hold for half an octave of tolerance.
constexpr int leastSteps = 4, leastStepsOfMuch = static_cast<int>(levelsPerOctave / 2.0);
constexpr double muchOfBody = 0.01;
// growing.md says on which structures these bounds were chosen, and what they do on others.
constexpr double leastLead = 0.35;   ///< of GrowthCurve: with less, another region is nearly as clear …
constexpr double rivalShare = 0.02;  ///< … which tells of a leak where a region is more of the body than most organs
constexpr double mostSprawl = 4.4;   ///< of GrowthCurve
constexpr double leastBoneLead = -0.55;  ///< of GrowthCurve: with less, it is a piece of a bone, or several of them
constexpr double mostFlatness = 1.5;     ///< of GrowthCurve: an artery beside its vein is a tube twice as wide as thick

double volumeAt(const Growth& growth, int step) { return growth.curve.volume[static_cast<std::size_t>(step)]; }

/// How many other steps hold the region by and large.
int stepsAlike(const Growth& growth, int step) {
  const double volume = volumeAt(growth, step);
  int first = step, last = step;
  while (first > 1 && leakGrowth * volumeAt(growth, first - 1) > volume) --first;
  while (last < stepCount && volumeAt(growth, last + 1) < leakGrowth * volume) ++last;
  return last - first;
}

Border borderAt(const Growth& growth, int step, double contrast) {
  const bool isSteady = std::any_of(growth.curve.plateaus.begin(), growth.curve.plateaus.end(),
                                    [&](const Plateau& each) { return each.first <= step && step <= each.last; });
  const double strong = std::min(strongEdge, strongShare * growth.curve.mostRise);
  const bool isStrong = contrast >= strong;
  const bool isRagged = growth.curve.compactness[static_cast<std::size_t>(step)] < leastCompact;
  if (contrast < (isRagged ? raggedEdge / strongEdge * strong : weakEdge)) return Border::Doubtful;
  return isSteady && isStrong ? Border::Clear : isSteady || isStrong ? Border::Fair : Border::Doubtful;
}

}  // namespace

bool isAir(const Volume& volume, glm::ivec3 voxel) {
  double sum = 0.0;
  for (int i = 0; i < 27; ++i) {
    const glm::ivec3 neighbour = voxel + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1;
    sum += volume.value(glm::clamp(neighbour, glm::ivec3(0), volume.grid.dims - 1));
  }
  const double mean = sum / 27.0;
  if (volume.isInHounsfieldUnits()) return mean < airThreshold;
  return !(mean > volume.range.low + airShare * (volume.range.high - volume.range.low));  // NaN is air
}

std::optional<double> shareOfBody(const Growth& growth, int step) {
  if (growth.bodyVolume <= 0.0) return std::nullopt;
  return volumeAt(growth, step) / growth.bodyVolume;
}

void GrowthFacts::Sums::add(const Sums& other) {
  voxels += other.voxels;
  value += other.value;
  square += other.square;
  place += other.place;
}

GrowthFacts::GrowthFacts(const Volume& volume, const Growth& growth)
    : grid_(volume.grid),
      // Squares of values near 0 lose no digits.
      reference_(0.5 * (volume.range.low + volume.range.high)),
      sums_(static_cast<std::size_t>(stepCount) + 1) {
  const std::span<const std::uint8_t> steps = growth.steps->voxels.as<std::uint8_t>();
  const VoxelBox& box = growth.box;
  std::vector<std::vector<Sums>> layers(static_cast<std::size_t>(std::max(0, box.dims().z)));
  volume.voxels.visit([&](auto values) {
    parallelFor(layers.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t layer = begin; layer < end; ++layer) {
        std::vector<Sums>& sums = layers[layer];
        sums.resize(sums_.size());
        const int z = box.low.z + static_cast<int>(layer);
        for (int y = box.low.y; y < box.high.y; ++y) {
          std::size_t at = grid_.offset({box.low.x, y, z});
          for (int x = box.low.x; x < box.high.x; ++x, ++at) {
            if (steps[at] == 0) continue;
            const double value = volume.slope * static_cast<double>(values[at]) + volume.intercept - reference_;
            if (std::isfinite(value)) sums[steps[at]].add({1.0, value, value * value, {x, y, z}});
          }
        }
      }
    });
  });
  // In their order: sums of doubles depend on it.
  for (const std::vector<Sums>& layer : layers)
    for (std::size_t step = 0; step < layer.size(); ++step) sums_[step].add(layer[step]);
}

GrowthFacts::Sums GrowthFacts::between(int after, int upTo) const {
  Sums sums;
  for (int step = after + 1; step <= upTo; ++step) sums.add(sums_[static_cast<std::size_t>(step)]);
  return sums;
}

std::optional<RegionFacts::Leak> GrowthFacts::leakAfter(const Growth& growth, int step) const {
  int cliff = step + 1;
  while (cliff <= stepCount && volumeAt(growth, cliff) < leakGrowth * volumeAt(growth, cliff - 1)) ++cliff;
  if (cliff > stepCount) return std::nullopt;
  const Sums region = between(0, step), joined = between(cliff - 1, cliff);
  RegionFacts::Leak leak{growth.toleranceOf(cliff), volumeAt(growth, cliff)};
  if (region.voxels == 0.0 || joined.voxels == 0.0) return leak;
  const auto middle = [&](const Sums& sums) {
    return glm::dvec3(grid_.worldFromIndex() * glm::dvec4(sums.place / sums.voxels, 1.0));
  };
  const glm::dvec3 offset = middle(joined) - middle(region);
  const double radius = std::cbrt(joined.voxels * grid_.voxelVolume() * 3.0 / (4.0 * std::numbers::pi));
  if (glm::length(offset) >= leastOffset * radius) leak.towards = glm::normalize(offset);
  return leak;
}

RegionFacts GrowthFacts::at(const Growth& growth, int step) const {
  RegionFacts facts;
  facts.volume = volumeAt(growth, step);
  const Sums sums = between(0, step);
  if (sums.voxels > 0.0) {
    const double mean = sums.value / sums.voxels;
    facts.mean = mean + reference_;
    facts.deviation = std::sqrt(std::max(0.0, sums.square / sums.voxels - mean * mean));
  }
  const std::vector<double>& contrasts = growth.curve.contrast;
  if (std::all_of(contrasts.begin(), contrasts.end(), [](double contrast) { return contrast == 0.0; })) return facts;
  const double contrast = std::max(0.0, contrasts[static_cast<std::size_t>(step)]);
  facts.contrast = contrast * growth.noise;
  const bool isMuch = shareOfBody(growth, step).value_or(0.0) > muchOfBody;
  facts.isPassing = stepsAlike(growth, step) < (isMuch ? leastStepsOfMuch : leastSteps);
  if (step == growth.curve.automatic) {
    facts.isRivalled = (shareOfBody(growth, step).value_or(0.0) > rivalShare && growth.curve.lead < leastLead) ||
                       growth.curve.boneLead < leastBoneLead;
    facts.sprawls = growth.curve.sprawl > mostSprawl;
    facts.isFlat = growth.curve.flatness > mostFlatness;
  }
  const bool isDoubtful = facts.isPassing || facts.isRivalled || facts.sprawls || facts.isFlat;
  facts.border = isDoubtful ? Border::Doubtful : borderAt(growth, step, contrast);
  facts.leak = leakAfter(growth, step);
  return facts;
}

}  // namespace fenestra::segmentation
