#pragma once
// How a grown region changes with its tolerance: plateaus, cliffs, and which tolerance to begin with.

#include <span>
#include <vector>

#include "rendering/segmentation/Levels.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Grid.h"

namespace fenestra::segmentation {

/// Tolerances count in steps: step n holds the voxels that join at levels 0 … n - 1; step 0 is empty.
inline constexpr int stepCount = levelCount;

/// A range of steps over which the region hardly changes, before a cliff.
struct Plateau {
  int first = 0, last = 0;
  int best = 0;           ///< the step whose surface lies best on edges
  double volume = 0.0;    ///< mm³ at `best`
  double contrast = 0.0;  ///< at `best`, in noise units
  bool operator==(const Plateau&) const = default;
};

/// One entry a step, [0, stepCount].
struct GrowthCurve {
  std::vector<double> volume;       ///< mm³; a leak is a cliff
  std::vector<double> contrast;     ///< mean rise of the cost across the region's surface, noise units
  std::vector<double> compactness;  ///< (36 π V²)^⅓ / area: the surface of the ball of that volume over the region's
  std::vector<Plateau> plateaus;    ///< ascending
  int automatic = 0;                ///< the step to begin with
  double clarity = 0.0;
};

/// `joins` and `costs` hold a box of `dims`: the level at which a voxel joins (or `never`), and its own cost.
/// `noiseShare` is Noise::share(): with less noise, less contrast makes a surface. Runs on all cores.
GrowthCurve growthCurve(std::span<const Level> joins, std::span<const Level> costs, const Grid& grid, glm::ivec3 dims,
                        double noiseShare);

}  // namespace fenestra::segmentation
