#pragma once
// A region grown from a click, for all tolerances at once.
//
// By values: the cost of a voxel is the distance of its value, freed of noise, from the seed's, in units of the noise.
// Values brighter than the seed cost less than darker ones, and a voxel on an edge costs as much as the tissue that it
// holds more of. A voxel joins the region at the least tolerance that lets a path from the seed reach it. Paths are as
// wide as a small ball, so that a leak narrower than the ball stays shut; a thinner path costs an extra amount, so that
// thin structures can be grown too. In the end the ball is put back.
//
// By tissues: the volume's tissues are found first, and merged two by two (TissueTree.h). A voxel joins at the cost of
// the first merge that holds it and the seed. In a CT the bone at the seed competes, too, parted from its neighbours at
// the joints (BoneTree.h), but not in volumes that are very large. So does the tube at the seed, a vessel that no
// border parts from what it touches (TubeTracer.h). Where values are no Hounsfield units, what a random walk
// from the seed hardly leaves competes as well, because the borders of MR have gaps (RandomWalk.h). A bone ends where a
// voxel holds less than half of it (BoneRim.h). Of all regions of the first seed, by values, by tissues, as a bone, as
// a tube and by the walk, the clearest one is chosen (Competition.h); one that is more of the body than a structure is
// only where nothing else is clear. A further seed adds its own clearest region at the same tolerance, and no larger
// one than its distance from the region lets expect. Seeds outside cut off their part of the chosen region
// (RegionCut.h), and no tolerance reaches them. Where the region may have leaked, and no shape parts a seed outside
// from the first one, the clearest region without that seed takes its place (Corrections.h). Further seeds of a walk's
// region are further ends of the walk.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "rendering/scene/Scene.h"
#include "rendering/segmentation/Curve.h"
#include "rendering/segmentation/GrowthMemory.h"
#include "rendering/segmentation/VoxelBox.h"

namespace fenestra::segmentation {

/// How a region looks until it is kept as a label: display RGB.
inline constexpr glm::dvec3 regionColour{0.95, 0.72, 0.30};

/// Every region that can be grown from the seeds. A tolerance is a threshold of `steps`: nothing is flooded again.
struct Growth {
  /// On the volume's grid, UInt8: the first step that holds the voxel, 0 where no tolerance reaches. What was painted
  /// belongs to every step, what was taken away to none. As a label map, the region of step n is the labels 1 … n, see
  /// DrawnScene.
  std::shared_ptr<const LabelMap> steps;
  VoxelBox box;        ///< where `steps` may be other than 0
  double noise = 1.0;  ///< Noise::unit, real values
  GrowthCurve curve;
  double bodyVolume = 0.0;  ///< mm³ of the volume that is no air; 0 for RegionRule::Values, which asks for none

  /// Real values below the seed's that step n allows, and the step that allows `tolerance`.
  double toleranceOf(int step) const;
  int stepOf(double tolerance) const;
  /// The step of the settings: their tolerance's, or the automatic one.
  int stepOf(const RegionFocus& settings) const;
};

/// Whether a seed of the region lies in the volume, or a stroke that adds to it reaches there.
bool canGrow(const Volume& volume, const RegionFocus& region);
/// Why a session's region is not shown where it cannot.
inline constexpr const char* cannotGrow =
    "the region in focus cannot be grown: none of its seeds or strokes lies in this volume";

/// Whether one growth serves both: they differ in their tolerance at most. Strokes belong to a growth.
bool haveSameSeeds(const RegionFocus& a, const RegionFocus& b);

/// The result of growRegion() for `wanted` in the whole volume, made from `growth`, that of a region with the same
/// seeds and the first of its strokes: only the other strokes are painted. Empty where `grownFrom` is not such a
/// region.
std::optional<Growth> paintedOn(const Growth& growth, const RegionFocus& grownFrom, const RegionFocus& wanted,
                                const Volume& volume);

/// Called now and then from the calling thread with a fraction in [0, 1]; false cancels.
using Progress = std::function<bool(double fraction)>;

/// The voxel that holds a world position; empty outside the volume.
std::optional<glm::ivec3> voxelAt(const Grid& grid, glm::dvec3 world);

/// The box of voxels around the first inside seed that shows a region at once: a few million voxels at most.
VoxelBox previewBox(const Volume& volume, const RegionFocus& settings);

/// Grows within `reach`, the whole volume for the final result or previewBox() for a first look. Seeds outside `reach`
/// are ignored, strokes are not; `settings.tolerance` is not used. Empty when cancelled. Takes five bytes a voxel of
/// `reach` while it runs, eight with outside seeds, beside the result's one. By tissues it grows the region by values,
/// too, and takes the clearer one, with what `memory` holds of the volume, and adds to that what it lacks. A first
/// look, in less than the whole volume, is by values. Runs on all cores; call it off the GUI thread.
std::optional<Growth> growRegion(const Volume& volume, const RegionFocus& settings, const VoxelBox& reach,
                                 const Progress& progress = {}, const GrowthMemory& memory = {});

}  // namespace fenestra::segmentation
