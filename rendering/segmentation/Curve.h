#pragma once
// How a grown region changes with its tolerance: plateaus, cliffs, and which tolerance to begin with.

#include <limits>
#include <optional>
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
};

/// `joins` and `costs` hold a box of `dims`: the level at which a voxel joins (or `never`), and its own cost.
/// `noiseShare` is Noise::share(): with less noise, less contrast makes a surface. Runs on all cores.
GrowthCurve growthCurve(std::span<const Level> joins, std::span<const Level> costs, const Grid& grid, glm::ivec3 dims,
                        double noiseShare);

/// Which sizes a structure may have in a body, mm³.
struct StructureSizes {
  double usual = 0.0;  ///< what is smaller is less likely to be meant, the more the smaller it is
  double most = 0.0;   ///< what is larger must be clearer
  double limit = std::numeric_limits<double>::infinity();     ///< what is larger is no structure
  double contrast = 0.0;                                      ///< noise units: a border with less is none
  double expected = std::numeric_limits<double>::infinity();  ///< what is larger is less likely to be meant
};
/// `body`: volume in mm³. Gas is the body's own: lungs may take up most of what a scan of the chest shows.
StructureSizes structureSizes(double body, bool isGas);

/// The step whose region is most clearly one structure, by the sharpness and compactness of its surface, by how far the
/// tolerance can rise until it changes, and by its size.
struct ClearestStep {
  int step = 0;
  double clarity = 0.0;  ///< a logarithm, comparable between curves of one volume
};
/// Empty where no region has a structure's size and a surface.
std::optional<ClearestStep> clearestStep(const GrowthCurve& curve, const StructureSizes& sizes, const Grid& grid);

/// Begins with `step`, which becomes a plateau where it is none.
void beginWith(GrowthCurve& curve, int step);

}  // namespace fenestra::segmentation
