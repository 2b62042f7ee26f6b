#pragma once
// The tube at a seed: a vessel, a duct, a cord, followed both ways along its middle line.
//
// Where a vessel lies beside tissue of its own density, no tolerance and no merge tells them apart; its shape does. The
// tube begins with the plane at the seed whose contour is clearest and least (TubeSection.h), and goes on in small
// steps along the chord of the last middles, each section expected to be like the one before. It ends where the wall is
// seen on too few sides, where it opens into something wider or splits into narrower ones, and at the volume's faces.
// The idea of a traversed centre line is Aylward and Bullitt's (2002), the rules are the program's own.

#include <optional>
#include <vector>

#include "rendering/segmentation/Levels.h"
#include "rendering/segmentation/Smoothing.h"
#include "rendering/segmentation/TubeSection.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// Sections in their order along the tube, closer to one another than the tube is wide.
struct Tube {
  std::vector<TubeSection> sections;
  std::size_t start = 0;  ///< where in the order it was begun
  double length = 0.0;    ///< mm, of the middle line
  double radius = 0.0;    ///< mm, mean
  double rise = 0.0;      ///< mean of TubeSection::rise
  double support = 0.0;   ///< mean of TubeSection::support
  double aspect = 1.0;    ///< median of TubeSection::aspect()

  double diameters() const { return (length + radius) / (2.0 * radius); }  ///< how often its width its length holds
};

/// The tube that holds a voxel of the volume; empty where what holds it is no tube, which is known soon. Deterministic.
/// Runs on all cores.
std::optional<Tube> traceTube(const Volume& volume, const Noise& noise, glm::ivec3 seed);

/// What a tube holds, as levels of a box that has its voxels.
struct TubeRegion {
  VoxelBox box;
  /// By voxel of the box: `tubeLevel` at the wall, less within, the deeper the less, and more outside, up to half a
  /// radius away. A tolerance makes the tube thinner and thicker.
  std::vector<Level> joins;
  double aspect = 1.0;  ///< Tube::aspect
};
inline constexpr Level tubeLevel = 64;
TubeRegion tubeRegion(const Volume& volume, const Tube& tube);
bool holds(const TubeRegion& tube, glm::ivec3 voxel);

}  // namespace fenestra::segmentation
