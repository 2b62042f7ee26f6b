#include "rendering/segmentation/RegionGrowing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

#include "rendering/segmentation/Competition.h"
#include "rendering/segmentation/Corrections.h"
#include "rendering/segmentation/MemoryBuild.h"
#include "rendering/segmentation/Painting.h"
#include "rendering/segmentation/ValueGrower.h"

namespace fenestra::segmentation {
namespace {

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
    if (settings.ball > 0.0) ball_ = RegionBall{settings.inside.front(), settings.ball};
  }

  /// By values alone.
  std::optional<Growth> run(const RegionFocus& settings) {
    const auto region = grownByValues(seedsIn(settings.inside), seedsIn(settings.outside));
    if (region) region->curve = curveOf(*region, {region->noise.share()});
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
        first->curve = curveOf(*first, competingEdges(volume_, first->noise));
        first->ball = settings.ball;
        first->centre = settings.inside.front();
        competitionOf(memory).decide(*first);
        memory.first() = std::move(first);
      }
    }
    if (!goOn(0.9)) return std::nullopt;
    const FirstRegion& first = *memory.first();
    const double body = memory.tissues()->bodyVolume();
    if (inside.size() == 1 && outside.empty()) return growthOf(first.joins, first.curve, first.noise, body);
    CorrectedRegion region = corrected(volume_, competitionOf(memory), first, inside, outside);
    return growthOf(region.joins, std::move(region.curve), first.noise, body);
  }

 private:
  Competition competitionOf(const GrowthMemory& memory) const {
    return {volume_, *memory.tissues(), memory.bones().get(), ball_};
  }

  /// Without its curve. Empty when cancelled.
  std::shared_ptr<FirstRegion> grownByValues(const std::vector<glm::ivec3>& inside,
                                             const std::vector<glm::ivec3>& outside) const {
    ValueGrower byValues(volume_, box_);
    std::optional<std::vector<Level>> joins = byValues.joins(inside, outside, progress_);
    if (!joins) return nullptr;
    keepTo(ball_, volume_.grid, box_, *joins);
    auto region = std::make_shared<FirstRegion>();
    region->seed = inside.front();
    region->joins = std::move(*joins);
    region->costs = byValues.takeCosts();
    region->noise = byValues.noise();
    return region;
  }

  GrowthCurve curveOf(const FirstRegion& region, const EdgeScale& edges) const {
    return growthCurve(region.joins, region.costs, volume_.grid, box_.dims(), edges);
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
  std::optional<RegionBall> ball_;
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
