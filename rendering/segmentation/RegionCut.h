#pragma once
// Parts a region between the seeds that belong to it and those that do not.

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "rendering/segmentation/Levels.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// What a cut costs: its area, and the volume that it takes away.
struct CutCost {
  /// 1/mm: the price of a mm³ that is taken, in mm² of cut. Seeds outside take little rather than much where the shape
  /// does not decide.
  double perVolume = 0.0;
  /// Real values: the cut is cheaper between voxels that differ, half as dear at this difference. Infinity: the shape
  /// alone decides.
  double edge = 0.0;
  /// mm³: a cut that leaves less takes what the seeds outside claim, and no more.
  double crumb = 0.0;
  /// mm³: a larger region may have leaked.
  double leak = std::numeric_limits<double>::infinity();
};

/// By voxel of the volume: 1 in what the seeds `outside` take away from a region, the voxels with `joins` < `step`; 0
/// everywhere where none of them lies in the region. The cheapest cut decides (Y. Boykov, M.-P. Jolly: Interactive
/// graph cuts for optimal boundary & region segmentation of objects in N-D images, ICCV 2001). A seed claims the
/// largest ball around it that the region holds: one in the middle of a part claims the part's body, one at the
/// surface a spot. A seed inside also claims the ball of the part that it lies in, wherever in it that is, unless a
/// seed outside claims its middle: a click at an organ's surface means the organ. What the cut parts from all seeds
/// `inside` is taken, too. Where a region may have leaked, and a seed outside lies in a far thicker part than the first
/// one inside, the price of volume turns over: each mm³ that lies nearer to that seed, along the region and measured in
/// its ball's radii, is paid for if it stays, so that the cut lies in a narrow place between both.
std::vector<std::uint8_t> cutOff(const Volume& volume, std::span<const Level> joins, int step,
                                 std::span<const glm::ivec3> inside, std::span<const glm::ivec3> outside,
                                 const CutCost& cost);

}  // namespace fenestra::segmentation
