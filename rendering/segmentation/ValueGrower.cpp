#include "rendering/segmentation/ValueGrower.h"

#include <algorithm>
#include <cassert>

#include "rendering/segmentation/Morphology.h"

namespace fenestra::segmentation {
namespace {

// Chosen on the marked structures of tests/bench/results/growing.md.
constexpr double passRadius = 1.5;    // voxel sides: leaks narrower than this ball are closed
constexpr double thinPathCost = 3.0;  // noise units, on top, for paths narrower than the ball
constexpr double regrowth = 1.0;      // voxel sides, beyond the ball that closes leaks: brings corners back
constexpr double seedRadius = 1.0;    // voxel sides: the ball whose median is the seed's value

/// The levels of costs raised by thinPathCost.
std::array<Level, 256> thinPathLevels() {
  std::array<Level, 256> levels{};
  for (int level = 0; level < levelCount; ++level)
    levels[static_cast<std::size_t>(level)] = levelOf(costOf(level) + thinPathCost);
  levels[never] = never;
  return levels;
}

/// The offsets of a ball that lead from `index` into `box`, as voxels.
std::vector<glm::ivec3> ballAround(glm::ivec3 index, const Grid& grid, double radius, const VoxelBox& box) {
  std::vector<glm::ivec3> voxels;
  for (const glm::ivec3 offset : ballOffsets(grid, radius))
    if (box.contains(index + offset)) voxels.push_back(index + offset);
  return voxels;
}

/// Median of the smoothed values around a seed.
float toneAt(glm::ivec3 seed, const Volume& volume, const ToneScale& scale) {
  const std::vector<glm::ivec3> around =
      ballAround(seed, volume.grid, seedRadius * voxelSide(volume.grid), wholeOf(volume.grid.dims));
  VoxelBox box{seed, seed + 1};
  for (const glm::ivec3 voxel : around) box = {glm::min(box.low, voxel), glm::max(box.high, voxel + 1)};
  const std::vector<float> values = smoothedTones(volume, box, scale);
  std::vector<float> chosen;
  for (const glm::ivec3 voxel : around) chosen.push_back(values[box.offset(voxel)]);
  const auto middle = chosen.begin() + static_cast<std::ptrdiff_t>(chosen.size() / 2);
  std::nth_element(chosen.begin(), middle, chosen.end());
  return *middle;
}

}  // namespace

ValueGrower::ValueGrower(const Volume& volume, const VoxelBox& box)
    : volume_(volume), box_(box), side_(voxelSide(volume.grid)), thin_(thinPathLevels()) {}

std::optional<std::vector<Level>> ValueGrower::joins(const std::vector<glm::ivec3>& inside,
                                                     const std::vector<glm::ivec3>& outside,
                                                     const std::function<bool(double)>& progress) {
  assert(!inside.empty());
  const auto goOn = [&](double fraction) { return !progress || progress(fraction); };
  noise_ = noiseOf(volume_);
  scale_.emplace(volume_, noise_, volume_.value(inside.front()));
  kinds_[0].seeds = inside;
  kinds_[1].seeds = outside;
  if (!computeCosts(goOn) || !goOn(0.4)) return std::nullopt;
  for (Kind& kind : kinds_)
    if (!kind.seeds.empty()) preparePaths(kind);
  if (!goOn(0.5)) return std::nullopt;
  std::optional<Flooded> flooded = floodBox(goOn);
  if (!flooded) return std::nullopt;
  std::vector<Level> joins = putBallsBack(*flooded);
  kinds_[0].wide = {};
  if (!goOn(0.8)) return std::nullopt;
  return joins;
}

/// False when cancelled.
bool ValueGrower::computeCosts(const std::function<bool(double)>& goOn) {
  std::vector<TissueCost> tissues;
  for (Kind& kind : kinds_) {
    if (kind.seeds.empty()) continue;
    std::vector<float> tones;
    for (const glm::ivec3 seed : kind.seeds) tones.push_back(toneAt(seed, volume_, *scale_));
    tissues.emplace_back(tones);
    kind.costs.resize(box_.count());
  }
  // A tile's intermediate arrays fit a core's cache.
  constexpr glm::ivec3 tile(128, 32, 32);
  const glm::ivec3 tiles = (box_.dims() + tile - 1) / tile;
  for (int z = 0; z < tiles.z; ++z) {
    if (!goOn(0.35 * z / tiles.z)) return false;
    parallelFor(static_cast<std::size_t>(tiles.x * tiles.y), 1, [&](std::size_t begin, std::size_t end) {
      EdgeSharpener sharpener(volume_, *scale_);
      for (int i = static_cast<int>(begin); i < static_cast<int>(end); ++i) {
        const glm::ivec3 low = box_.low + glm::ivec3(i % tiles.x, i / tiles.x, z) * tile;
        costsOf(VoxelBox{low, low + tile}.clippedTo(box_), tissues, sharpener);
      }
    });
  }
  return true;
}

void ValueGrower::costsOf(const VoxelBox& tile, const std::vector<TissueCost>& tissues, EdgeSharpener& sharpener) {
  sharpener.read(tile);
  for (std::size_t k = 0; k < tissues.size(); ++k)
    sharpener.forRows(tissues[k], [&](int y, int z, std::span<const Level> levels) {
      std::copy(levels.begin(), levels.end(), kinds_[k].costs.data() + box_.offset({tile.low.x, y, z}));
    });
}

/// A path's cost at a voxel: as wide as the ball, or thinner at the extra cost.
void ValueGrower::preparePaths(Kind& kind) {
  kind.wide = greatestWithin(kind.costs, box_.dims(), ballOffsets(volume_.grid, passRadius * side_));
  kind.paths.emplace(box_.dims());
  forRows(box_.dims(), [&](int y, int z, std::size_t begin) {
    Level* to = kind.paths->row(y, z);
    for (std::size_t x = 0; x < static_cast<std::size_t>(box_.dims().x); ++x)
      to[x] = std::min(thin_[kind.costs[begin + x]], kind.wide[begin + x]);
  });
  // The ball of a wide path need not have its centre at the seed.
  for (glm::ivec3& seed : kind.seeds) {
    glm::ivec3 best = seed - box_.low;
    for (const glm::ivec3 voxel : ballAround(seed, volume_.grid, passRadius * side_, box_)) {
      const glm::ivec3 at = voxel - box_.low;
      if (kind.paths->all()[kind.paths->offset(at)] < kind.paths->all()[kind.paths->offset(best)]) best = at;
    }
    seed = best;
  }
}

std::optional<Flooded> ValueGrower::floodBox(const std::function<bool(double)>& goOn) {
  bool cancelled = false;
  FloodSource inside{&*kinds_[0].paths, kinds_[0].seeds}, outside;
  if (kinds_[1].paths) outside = {&*kinds_[1].paths, kinds_[1].seeds};
  Flooded flooded = flood(inside, outside, [&](double fraction) {
    cancelled = !goOn(0.5 + 0.3 * fraction);
    return !cancelled;
  });
  if (cancelled) return std::nullopt;
  for (Kind& kind : kinds_) kind.paths.reset();
  return flooded;
}

/// The level at which each voxel of the box joins.
std::vector<Level> ValueGrower::putBallsBack(const Flooded& flooded) {
  std::vector<Level>& wide = kinds_[0].wide;
  const std::vector<Level>& costs = kinds_[0].costs;
  std::vector<Level> thin(box_.count()), joins(box_.count(), never);
  forRows(box_.dims(), [&](int y, int z, std::size_t begin) {
    const std::size_t padded = flooded.reached.offset({0, y, z});
    for (std::size_t x = 0; x < static_cast<std::size_t>(box_.dims().x); ++x) {
      const bool lost = !flooded.outside.empty() && flooded.outside[padded + x];
      const Level reached = lost ? never : flooded.reached.all()[padded + x];
      thin[begin + x] = std::max(reached, thin_[costs[begin + x]]);
      wide[begin + x] = std::max(reached, wide[begin + x]);
    }
  });
  lowerToLeastWithin(wide, box_.dims(), ballOffsets(volume_.grid, (passRadius + regrowth) * side_), joins);
  lowerToLeastWithin(thin, box_.dims(), ballOffsets(volume_.grid, regrowth * side_), joins);
  forRows(box_.dims(), [&](int y, int z, std::size_t begin) {
    const std::size_t padded = flooded.reached.offset({0, y, z});
    for (std::size_t x = 0; x < static_cast<std::size_t>(box_.dims().x); ++x) {
      const bool lost = !flooded.outside.empty() && flooded.outside[padded + x];
      joins[begin + x] = lost ? never : std::max(joins[begin + x], costs[begin + x]);
    }
  });
  return joins;
}

}  // namespace fenestra::segmentation
