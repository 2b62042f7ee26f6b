#pragma once
// How a grown region changes with its tolerance: plateaus, cliffs, and which tolerance to begin with.

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "rendering/segmentation/Levels.h"
#include "rendering/segmentation/Smoothing.h"
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

/// How differences of costs are judged, in noise units.
struct EdgeScale {
  double noise = 1.0;     ///< Noise::share(): with less noise, less contrast makes a surface
  double mostRise = 6.0;  ///< a sharper edge is no better
};
/// For regions that compete. Loud noise is a large unit: six of it would be a difference that only air and bone make,
/// and what leaks to these would look sharper than an organ. So in Hounsfield units no more than 80 HU count, by which
/// soft tissues differ.
EdgeScale competingEdges(const Volume& volume, const Noise& noise);

/// One entry a step, [0, stepCount].
struct GrowthCurve {
  std::vector<double> volume;       ///< mm³; a leak is a cliff
  std::vector<double> contrast;     ///< mean rise of the cost across the region's surface, noise units
  std::vector<double> compactness;  ///< (36 π V²)^⅓ / area: the surface of the ball of that volume over the region's
  std::vector<Plateau> plateaus;    ///< ascending
  int automatic = 0;                ///< the step to begin with
  double mostRise = EdgeScale{}.mostRise;  ///< the greatest contrast that there can be
  /// The clarity of the region at `automatic`, where it has won over others at a click, less that of the clearest one
  /// that is at most half or at least twice as large.
  double lead = std::numeric_limits<double>::infinity();
  /// As `lead`, of a bone, beside what is at least twice as large: its neighbours with it, across their joints.
  double boneLead = std::numeric_limits<double>::infinity();
  double sprawl = 1.0;    ///< of that region: RegionShape::thickening over its compactness
  double flatness = 1.0;  ///< of that region, where it is a tube: Tube::aspect
};

/// `joins` and `costs` hold a box of `dims`: the level at which a voxel joins (or `never`), and its own cost.
/// Runs on all cores.
GrowthCurve growthCurve(std::span<const Level> joins, std::span<const Level> costs, const Grid& grid, glm::ivec3 dims,
                        const EdgeScale& edges);

/// What is known of a structure before its region is: sizes in mm³, and its border.
struct StructurePrior {
  double usual = 0.0;  ///< a smaller region is less likely to be meant, the more the smaller it is
  double most = 0.0;   ///< a larger region counts only where no other one is clear
  /// A larger region is less likely to be meant, the more the larger it is.
  double much = std::numeric_limits<double>::infinity();
  double limit = std::numeric_limits<double>::infinity();     ///< a larger region is no structure
  double expected = std::numeric_limits<double>::infinity();  ///< a larger region is less likely to be meant
  double contrast = 0.0;                                      ///< noise units: a surface with less is no border
  double smallerHandicap = 0.0;  ///< a smaller region must be clearer than a larger one by this much
};
/// What is expected of a structure in a body of `body` mm³. A region of gas may be larger than others: lungs take up
/// most of what a scan of the chest shows.
StructurePrior structurePrior(double body, bool isGas);
/// What the clarity of a region of `volume` mm³ loses because it is larger than StructurePrior::much. Nothing where it
/// is larger than StructurePrior::most, which costs more already.
double costOfMuch(double volume, const StructurePrior& prior);

struct ClearestStep {
  int step = 0;
  double clarity = 0.0;  ///< the greatest of all steps: a logarithm, comparable between curves of one volume
};
/// The step up to `last` whose region is most clearly one structure: its surface is sharp and compact, the tolerance
/// can rise far until it changes, and its size is a structure's. Empty where no region is one.
std::optional<ClearestStep> clearestStep(const GrowthCurve& curve, const StructurePrior& prior, const Grid& grid,
                                         int last = stepCount);

/// The clarity of the region at a step, as clearestStep() sees it; -inf where it is none.
double clarityAt(const GrowthCurve& curve, int step, const StructurePrior& prior, const Grid& grid);
/// The greatest clarity of the regions that are at most half or at least twice as large as `volume` mm³; -inf without
/// one.
double clarityBeside(const GrowthCurve& curve, double volume, const StructurePrior& prior, const Grid& grid);
/// That of those at least twice as large.
double clarityBeyond(const GrowthCurve& curve, double volume, const StructurePrior& prior, const Grid& grid);

/// Begins with `step`, which becomes a plateau where it is none.
void beginWith(GrowthCurve& curve, int step);

}  // namespace fenestra::segmentation
